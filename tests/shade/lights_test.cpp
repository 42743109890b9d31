// Several lights, and lights at points.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/shade/appearance.h>
#include <libhair/shade/srgb.h>

namespace hair {
namespace {

using Colours = std::vector<std::uint32_t>;

Colours coloursOf(StrandView strands, const std::vector<Light>& lights,
                  const KajiyaKaySettings& settings = {}, const std::vector<float>& t = {},
                  const std::vector<float>& v = {}, glm::vec3 pivot = glm::vec3(0)) {
  Colours out(strands.pointCount());
  shade(strands, {lights, pivot, {0.3f, 0.2f, 1}, t, v}, settings, {}, out);
  return out;
}

int byte(std::uint32_t colour, int channel) {
  return static_cast<int>(colour >> (8 * channel) & 255u);
}

double linearOf(double b) {
  const double s = std::max(b, 0.0) / 255;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// The linear light that a byte may stand for (SrgbTable is within 0.65 of the exact curve).
struct Range {
  double least, most;
  explicit Range(int b) : least(linearOf(b - 0.65)), most(linearOf(b + 0.65)) {}
};

/// Strands of every direction within some 0.1 m of the origin.
StrandSet bush(std::uint32_t count = 300) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < count; ++s) {
    glm::vec3 p = 0.1f * glm::vec3(uniform(s, 1), uniform(s, 2), uniform(s, 3)) - 0.05f;
    const glm::vec3 along = glm::vec3(uniform(s, 4), uniform(s, 5), uniform(s, 6)) - 0.5f;
    std::vector<glm::vec3> points;
    for (std::uint32_t k = 0; k < 5 + s % 9; ++k, p += 0.02f * along) points.push_back(p);
    strands.append(points);
  }
  return strands;
}

std::vector<float> shares(std::size_t count, std::uint32_t seed) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = uniform(static_cast<std::uint32_t>(i), seed);
  return values;
}

std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Lights, AddUpBeforeTheEncoding) {
  const StrandSet strands = bush();
  const std::size_t n = strands.pointCount();
  const Light a = Light::parallel({1, -1, -0.5f}, {0.6f, 0.3f, 0.1f});
  const Light b = Light::point({-0.4f, 0.3f, 0.2f}, {0.1f, 0.4f, 0.5f});
  const auto ta = shares(n, 1), tb = shares(n, 2), va = shares(n, 3), vb = shares(n, 4);
  KajiyaKaySettings look;
  look.rootColour = look.tipColour = glm::vec3(0.5f);
  const Colours both = coloursOf(strands, {a, b}, look, joined(ta, tb), joined(va, vb));
  const Colours onlyA = coloursOf(strands, {a}, look, ta, va),
                onlyB = coloursOf(strands, {b}, look, tb, vb);
  const Colours ambient = coloursOf(strands, {}, look);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) {
      if (byte(both[i], c) == 255) continue;
      const Range sum(byte(both[i], c)), first(byte(onlyA[i], c)), second(byte(onlyB[i], c)),
          less(byte(ambient[i], c));
      ASSERT_LE(sum.least, first.most + second.most - less.least + 1e-6) << i;
      ASSERT_GE(sum.most, first.least + second.least - less.most - 1e-6) << i;
      compared += byte(onlyA[i], c) > byte(ambient[i], c) + 8 &&
                  byte(onlyB[i], c) > byte(ambient[i], c) + 8;
    }
  EXPECT_GT(compared, n / 4) << "both lights must matter";
  // Which comes first is nothing to see.
  const Colours turned = coloursOf(strands, {b, a}, look, joined(tb, ta), joined(vb, va));
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(byte(both[i], c), byte(turned[i], c), 1);
}

TEST(Lights, HaveShadowsOfTheirOwn) {
  const StrandSet strands = bush();
  const std::size_t n = strands.pointCount();
  const Light red = Light::parallel({1, -0.2f, 0}, {1, 0, 0});
  const Light blue = Light::parallel({-1, -0.2f, 0}, {0, 0, 1});
  KajiyaKaySettings look;
  look.ambient = 0;
  const std::vector<float> light(n, 1.0f), dark(n, 0.0f);
  const Colours onlyBlue = coloursOf(strands, {red, blue}, look, joined(dark, light));
  EXPECT_EQ(onlyBlue, coloursOf(strands, {blue}, look));
  EXPECT_EQ(onlyBlue, coloursOf(strands, {red, blue}, look, {}, joined(dark, light)));
  EXPECT_EQ(coloursOf(strands, {red, blue}, look, joined(light, dark)),
            coloursOf(strands, {red}, look));
}

TEST(Lights, AmbientLightIsNoLightsAndWhite) {
  const StrandSet strands = bush();
  const std::vector<float> dark(strands.pointCount(), 0.0f);
  const Colours none = coloursOf(strands, {});
  EXPECT_EQ(none, coloursOf(strands, {Light::parallel({0, -1, 0}, {5, 0, 1})}, {}, dark));
  EXPECT_EQ(none, coloursOf(strands, {Light::point({0, 1, 0}, {0, 0, 0})}));
  KajiyaKaySettings look;
  look.variation = 0;
  look.ambient = 1;
  look.rootColour = look.tipColour = {0.5f, 0.25f, 0.125f};
  for (std::uint32_t c : coloursOf(strands, {}, look))
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(byte(c, k), 255 * srgbFromLinear(look.rootColour[k]), 0.65 + 1e-3);
}

TEST(Lights, FarAwayAtAPointAreParallel) {
  const StrandSet strands = bush();
  const glm::vec3 way = glm::normalize(glm::vec3(0.5f, -0.8f, 0.3f)), pivot(0.02f, 0.01f, -0.03f);
  const glm::vec3 colour(0.9f, 0.7f, 0.5f);
  const Colours parallel = coloursOf(strands, {Light::parallel(way, colour)});
  const Colours far =
      coloursOf(strands, {Light::point(pivot - 1e4f * way, colour)}, {}, {}, {}, pivot);
  const Colours near =
      coloursOf(strands, {Light::point(pivot - 0.2f * way, colour)}, {}, {}, {}, pivot);
  int most = 0;
  for (std::size_t i = 0; i < parallel.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(byte(parallel[i], c), byte(far[i], c), 1);
      most = std::max(most, std::abs(byte(parallel[i], c) - byte(near[i], c)));
    }
  EXPECT_GT(most, 10) << "and near by they are not";
}

TEST(Lights, AtAPointFallOffWithTheSquareOfTheDistance) {
  // Diffuse light across a strand that the light looks at, which stands at several distances.
  KajiyaKaySettings look = KajiyaKaySettings::plain();
  look.rootColour = look.tipColour = glm::vec3(1);
  look.ambient = look.specular = 0;
  const auto seenAt = [&](float distance, float colour) {
    StrandSet strand;
    strand.append(
        std::vector<glm::vec3>{{distance, -1e-3f, 0}, {distance, 0, 0}, {distance, 1e-3f, 0}});
    // The light is at the origin, the pivot a metre away.
    return byte(
        coloursOf(strand, {Light::point({0, 0, 0}, glm::vec3(colour))}, look, {}, {}, {0, 0, 1})[1],
        0);
  };
  for (float distance : {0.5f, 1.0f, 2.0f, 3.0f})
    EXPECT_NEAR(seenAt(distance, 0.2f), 255 * srgbFromLinear(0.2f / (distance * distance)), 1)
        << distance;
  // A lamp is no smaller than a centimetre.
  EXPECT_NEAR(seenAt(0.01f, 5e-5f), 255 * srgbFromLinear(0.5f), 1);
  EXPECT_NEAR(seenAt(0.003f, 5e-5f), seenAt(0.01f, 5e-5f), 1);
}

TEST(Lights, HaveTheSameBitsForAnyThreadCount) {
  const StrandSet strands = bush(3000);
  const std::vector<Light> lights = {Light::point({0.2f, 0.1f, 0}), Light::parallel({1, 0, 0}),
                                     Light::point({0, 0.01f, 0}, {1, 0.5f, 0})};
  Colours first;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const Colours colours = coloursOf(strands, lights);
    if (first.empty()) first = colours;
    EXPECT_EQ(colours, first);
  }
}

TEST(Lights, ThatCannotBeAreReported) {
  const StrandSet strands = bush(3);
  const std::size_t n = strands.pointCount();
  const Light light;
  EXPECT_THROW(coloursOf(strands, {light, light}, {}, shares(n, 1)), Error);
  EXPECT_THROW(coloursOf(strands, {light}, {}, {}, shares(2 * n, 1)), Error);
  EXPECT_THROW(coloursOf(strands, {}, {}, shares(n, 1)), Error);
  EXPECT_THROW(coloursOf(strands, {Light::parallel({0, 0, 0})}), Error);
  EXPECT_THROW(coloursOf(strands, {light, Light::parallel({NAN, 0, 0})}), Error);
  EXPECT_THROW(coloursOf(strands, {Light::point({1, 2, 3})}, {}, {}, {}, {1, 2, 3}), Error);
  EXPECT_THROW(coloursOf(strands, {Light::parallel({0, -1, 0}, {1, -1, 1})}), Error);
  EXPECT_THROW(coloursOf(strands, {Light::parallel({0, -1, 0}, {1, NAN, 1})}), Error);
}

}  // namespace
}  // namespace hair

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/shade/kajiya_kay.h>
#include <libhair/shade/srgb.h>

namespace hair {
namespace {

/// One parallel light, and the eye.
struct WhiteLight {
  glm::vec3 direction{0, -1, 0};
  glm::vec3 eye{0, 0, 1};
};

/// White hair with one white light: what comes out is the bare model.
KajiyaKaySettings bare(float ambient, float diffuse, float specular) {
  KajiyaKaySettings settings = KajiyaKaySettings::plain();
  settings.rootColour = settings.tipColour = glm::vec3(1);
  settings.ambient = ambient;
  settings.diffuse = diffuse;
  settings.specular = specular;
  return settings;
}

StrandSet straight(glm::vec3 direction, int points = 5) {
  StrandSet strands;
  std::vector<glm::vec3> p;
  for (int k = 0; k < points; ++k) p.push_back(0.01f * static_cast<float>(k) * direction);
  strands.append(p);
  return strands;
}

int red(std::uint32_t colour) {
  return static_cast<int>(colour & 255u);
}
int green(std::uint32_t colour) {
  return static_cast<int>(colour >> 8 & 255u);
}
int blue(std::uint32_t colour) {
  return static_cast<int>(colour >> 16 & 255u);
}

std::vector<std::uint32_t> shadeAll(StrandView strands, const WhiteLight& light,
                                    const KajiyaKaySettings& settings,
                                    const std::vector<float>& t = {},
                                    const std::vector<float>& v = {}) {
  std::vector<std::uint32_t> out(strands.pointCount());
  const Light parallel = Light::parallel(light.direction);
  shadeKajiyaKay(strands, {{&parallel, 1}, glm::vec3(0), light.eye, t, v}, settings, out);
  return out;
}

int byteOf(float linear) {
  return static_cast<int>(std::lround(255 * srgbFromLinear(linear)));
}

TEST(Srgb, IsExactAtItsEndsAndCloseBetween) {
  const SrgbTable& table = SrgbTable::get();
  EXPECT_EQ(table(0.0f), 0);
  EXPECT_EQ(table(1.0f), 255);
  EXPECT_EQ(table(-3.0f), 0);
  EXPECT_EQ(table(1e9f), 255);
  EXPECT_EQ(table(NAN), 0);
  EXPECT_EQ(table(std::nextafter(1.0f, 0.0f)), 255);
  int before = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float x = static_cast<float>(i) * 1e-5f;
    ASSERT_NEAR(table(x), 255 * srgbFromLinear(x), 0.65) << x;
    ASSERT_GE(table(x), before);
    before = table(x);
  }
  // Every byte comes back from the linear value that it stands for.
  for (int b = 0; b < 256; ++b) {
    const double s = b / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    EXPECT_EQ(table(static_cast<float>(linear)), b);
  }
}

TEST(KajiyaKay, LightAlongTheTangentGivesNoDiffuseLight) {
  const StrandSet strand = straight({0, -1, 0});
  WhiteLight light;
  light.direction = {0, -1, 0};
  light.eye = {0, 0, 10};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 1, 0))) EXPECT_LE(red(c), 2);
  // And across it all of it; in between the sine.
  light.direction = {0, 0, -1};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 0.5f, 0)))
    EXPECT_NEAR(red(c), byteOf(0.5f), 1);
  light.direction = {0, -0.8f, -0.6f};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 0.5f, 0)))
    EXPECT_NEAR(red(c), byteOf(0.3f), 1);
}

TEST(KajiyaKay, HighlightPeaksOnTheConeOfTheMirroredRay) {
  // The strand runs along x through the origin; light falls in at 30 degrees off its normal and
  // leaves at 30 degrees to the other side, in every direction around the strand.
  const StrandSet strand = straight({1, 0, 0}, 3);
  WhiteLight light;
  light.direction = glm::normalize(glm::vec3(std::sin(0.5236f), -std::cos(0.5236f), 0));
  const auto seenAt = [&](float angle, float around, const KajiyaKaySettings& settings) {
    light.eye = 1000.0f * glm::vec3(std::sin(angle), std::cos(angle) * std::cos(around),
                                    std::cos(angle) * std::sin(around));
    return red(shadeAll(strand, light, settings)[0]);
  };
  for (float around : {0.0f, 1.0f, 2.5f}) {
    const auto settings = bare(0, 0, 0.8f);
    EXPECT_NEAR(seenAt(0.5236f, around, settings), byteOf(0.8f), 1);
    EXPECT_NEAR(seenAt(0.5236f + 0.2f, around, settings),
                byteOf(0.8f * std::pow(std::cos(0.2f), settings.exponent)), 2);
    EXPECT_NEAR(seenAt(0.5236f - 0.2f, around, settings),
                byteOf(0.8f * std::pow(std::cos(0.2f), settings.exponent)), 2);
  }
  // Shifted towards the tip (+x): the eye must look less from the tip's side to see the peak.
  auto shifted = bare(0, 0, 0.8f);
  shifted.firstShift = 0.1f;
  const float toRoot = 0.5236f - 0.1f, toTip = 0.5236f + 0.1f;
  EXPECT_NE(seenAt(toRoot, 0, shifted), seenAt(toTip, 0, shifted));
  EXPECT_NEAR(std::max(seenAt(toRoot, 0, shifted), seenAt(toTip, 0, shifted)), byteOf(0.8f), 1);
}

TEST(KajiyaKay, SecondHighlightLiesNearerToTheTipAndHasTheHairsColour) {
  // Hair over a crown, lit from above, seen from the front: from horizontal at the root to
  // hanging at the tip.
  StrandSet strand;
  std::vector<glm::vec3> p;
  for (int k = 0; k <= 400; ++k) {
    const float a = 1.5707963f * static_cast<float>(k) / 400;
    p.push_back(0.1f * glm::vec3(0, std::cos(a), std::sin(a)));
  }
  strand.append(p);
  WhiteLight light;
  light.direction = {0, -1, 0};
  light.eye = {0, 0, 1000};
  const auto peak = [&](KajiyaKaySettings settings) {
    const auto colours = shadeAll(strand, light, settings);
    std::size_t sum = 0, weight = 0;
    for (std::size_t k = 0; k < colours.size(); ++k)
      if (red(colours[k]) > 120) sum += k, ++weight;
    EXPECT_GT(weight, 0u);
    return static_cast<double>(sum) / static_cast<double>(weight);
  };
  KajiyaKaySettings first;
  first.ambient = first.diffuse = first.secondSpecular = first.variation = 0;
  first.specular = 1;
  KajiyaKaySettings second = first;
  second.specular = 0;
  second.secondSpecular = 1;
  second.secondExponent = 48;
  second.rootColour = second.tipColour = {1, 0, 0};
  const double plainPeak = peak([&] {
    auto s = first;
    s.firstShift = 0;
    return s;
  }());
  EXPECT_NEAR(plainPeak, 200, 2);
  EXPECT_LT(peak(first), plainPeak - 3);
  EXPECT_GT(peak(second), plainPeak + 3);
  for (std::uint32_t c : shadeAll(strand, light, second)) EXPECT_EQ(green(c) + blue(c), 0);
}

TEST(KajiyaKay, BrightnessGrowsWithTransmittanceFromAmbientToFull) {
  const StrandSet strand = straight({0, 1, 0}, 200);
  std::vector<float> t(200), ones(200, 1.0f);
  for (int k = 0; k < 200; ++k) t[static_cast<std::size_t>(k)] = static_cast<float>(k) / 199;
  WhiteLight light;
  light.direction = {0, 0, -1};
  light.eye = {0, 1, 100};
  const auto settings = bare(0.1f, 0.5f, 0.2f);
  const auto colours = shadeAll(strand, light, settings, t);
  for (std::size_t k = 1; k < colours.size(); ++k) ASSERT_GE(red(colours[k]), red(colours[k - 1]));
  EXPECT_NEAR(red(colours.front()), byteOf(0.1f), 1);
  EXPECT_NEAR(red(colours.back()), byteOf(0.8f), 1);
  // No shadows: the same as full transmittance. Visibility: the same as transmittance.
  EXPECT_EQ(shadeAll(strand, light, settings), shadeAll(strand, light, settings, ones, ones));
  EXPECT_EQ(colours, shadeAll(strand, light, settings, {}, t));
}

TEST(KajiyaKay, ColourRunsFromRootToTipAndVariesByStrandAroundIt) {
  StrandSet strands;
  for (int s = 0; s < 400; ++s)
    strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.1f, 0}, {0, 0.2f, 0}});
  auto settings = bare(1, 0, 0);
  settings.rootColour = {0.2f, 0.4f, 0.1f};
  settings.tipColour = {0.6f, 0.2f, 0.3f};
  const auto same = shadeAll(strands, {}, settings);
  EXPECT_EQ(red(same[0]), byteOf(0.2f));
  EXPECT_EQ(green(same[1]), byteOf(0.3f));
  EXPECT_EQ(blue(same[2]), byteOf(0.3f));
  EXPECT_EQ(same[0] >> 24, 255u);
  EXPECT_EQ(same[3], same[0]);
  settings.variation = 0.5f;
  const auto varied = shadeAll(strands, {}, settings);
  int least = 255, most = 0;
  for (std::size_t s = 0; s < 400; ++s) {
    least = std::min(least, red(varied[3 * s]));
    most = std::max(most, red(varied[3 * s]));
  }
  EXPECT_NEAR(least, byteOf(0.1f), 3);
  EXPECT_NEAR(most, byteOf(0.3f), 3);
}

TEST(KajiyaKay, HasTheSameBitsForAnyThreadCountAndForStrandsAlone) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < 1000; ++s) {
    std::vector<glm::vec3> p;
    for (std::uint32_t k = 0; k < 1 + s % 40; ++k)
      p.push_back({uniform(s, k), uniform(s, k, 1), uniform(s, k, 2)});
    strands.append(p);
  }
  std::vector<std::uint32_t> first;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const auto colours = shadeAll(strands, {}, {});
    if (first.empty()) first = colours;
    EXPECT_EQ(colours, first);
  }
  auto settings = KajiyaKaySettings();
  settings.variation = 0;
  const auto together = shadeAll(strands, {}, settings);
  for (std::size_t s = 0; s < 100; ++s) {
    StrandSet alone;
    alone.append(strands.strand(s));
    const auto colours = shadeAll(alone, {}, settings);
    for (std::size_t k = 0; k < colours.size(); ++k)
      ASSERT_EQ(colours[k], together[strands.first[s] + k]);
  }
}

// Strands of the lengths at which blocks of sixteen begin and end.
StrandSet ofManyLengths() {
  StrandSet strands;
  for (std::uint32_t s = 0; s < 300; ++s) {
    constexpr std::uint32_t kCounts[] = {2, 15, 16, 17, 33, 1, 130};
    std::vector<glm::vec3> p;
    for (std::uint32_t k = 0; k < kCounts[s % 7]; ++k)
      p.push_back({uniform(s, k), uniform(s, k, 1), uniform(s, k, 2)});
    strands.append(p);
  }
  return strands;
}

TEST(KajiyaKay, IsWhatThePlainFormulaSays) {
  const StrandSet strands = ofManyLengths();
  const KajiyaKaySettings look;
  WhiteLight light{glm::normalize(glm::vec3(1, -2, 0.5f)), {0.3f, 3, 2}};
  KajiyaKaySettings same = look;
  same.variation = 0;
  const auto colours = shadeAll(strands, light, same);
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto p = strands.strand(s);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const glm::dvec3 t(p[std::min(k + 1, p.size() - 1)] - p[k > 0 ? k - 1 : 0]);
      glm::dvec3 own(look.ambient);
      double white = 0;
      if (glm::length(t) > 0) {
        const double a = std::acos(glm::dot(glm::normalize(t), -glm::dvec3(light.direction)));
        const double b = std::acos(
            glm::dot(glm::normalize(t), glm::normalize(glm::dvec3(light.eye) - glm::dvec3(p[k]))));
        const auto peak = [&](double shift, double exponent) {
          return std::pow(std::max(std::cos(a + b - 3.14159265358979 - shift), 0.0), exponent);
        };
        own += look.diffuse * std::sin(a) +
               look.secondSpecular * peak(look.secondShift, look.secondExponent);
        white = look.specular * peak(look.firstShift, look.exponent);
      }
      const float u = p.size() > 1 ? static_cast<float>(k) / static_cast<float>(p.size() - 1) : 0;
      const glm::vec3 expected =
          glm::vec3(own) * glm::mix(look.rootColour, look.tipColour, u) + glm::vec3(float(white));
      const std::uint32_t c = colours[strands.first[s] + k];
      ASSERT_NEAR(red(c), 255 * srgbFromLinear(expected.x), 0.75) << s << ' ' << k;
      ASSERT_NEAR(green(c), 255 * srgbFromLinear(expected.y), 0.75) << s << ' ' << k;
      ASSERT_NEAR(blue(c), 255 * srgbFromLinear(expected.z), 0.75) << s << ' ' << k;
    }
  }
}

TEST(KajiyaKay, HasTheSameBitsOnEveryInstructionSetAndForRanges) {
  const StrandSet strands = ofManyLengths();
  std::vector<float> t, v;
  for (std::uint32_t i = 0; i < 2 * strands.pointCount(); ++i)
    t.push_back(uniform(i, 7)), v.push_back(uniform(i, 8));
  const Light lights[] = {Light::parallel({1, -1, 0.3f}, {0.8f, 0.7f, 0.6f}),
                          Light::point({0.5f, 1.5f, 0.5f}, {0.2f, 0.3f, 0.4f})};
  const Illumination illumination{lights, glm::vec3(0), {0, 1, 3}, t, v};
  std::vector<std::uint32_t> best;
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    std::vector<std::uint32_t> out(strands.pointCount());
    shadeKajiyaKay(strands, illumination, {}, out);
    if (best.empty()) best = out;
    EXPECT_EQ(out, best) << name;
    std::fill(out.begin(), out.end(), 0u);
    for (std::size_t s = 0; s < 300; s += 25)
      shadeKajiyaKay(strands, s, s + 25, illumination, {}, out);
    EXPECT_EQ(out, best) << name << ", in ranges";
  }
}

TEST(KajiyaKay, DegenerateStrandsAreAmbient) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{1, 2, 3}});
  strands.append(std::vector<glm::vec3>{});
  strands.append(std::vector<glm::vec3>{{1, 2, 3}, {1, 2, 3}});
  for (std::uint32_t c : shadeAll(strands, {}, bare(0.25f, 1, 1))) EXPECT_EQ(red(c), byteOf(0.25f));
  EXPECT_TRUE(shadeAll(StrandSet{}, {}, {}).empty());
  EXPECT_THROW(shadeAll(strands, {}, {}, {1.0f}), Error);
}

}  // namespace
}  // namespace hair

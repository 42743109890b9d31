#include <gtest/gtest.h>

#include <memory>

#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/shadow/methods/deep_shadow_map.h>
#include <libhair/shadow/methods/density_clustering.h>
#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

#include "../fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;
using test::kSlanted;
using test::largestDifference;

struct Case {
  const char* name;
  std::unique_ptr<ShadowMethod> (*make)(float pixelSize, LateralFilter filter);
  bool exact = false;  // each pixel's own function, whole
};

template <int Clusters, DensityClusteringSettings::Start From>
std::unique_ptr<ShadowMethod> clustering(float pixelSize, LateralFilter filter) {
  DensityClusteringSettings settings;
  settings.pixelSize = pixelSize;
  settings.clusters = Clusters;
  settings.start = From;
  settings.filter = filter;
  return makeDensityClustering(settings);
}

template <int Thousandths>
std::unique_ptr<ShadowMethod> deepShadowMap(float pixelSize, LateralFilter filter) {
  DeepShadowMapSettings settings;
  settings.pixelSize = pixelSize;
  settings.tolerance = 1e-3f * Thousandths;
  settings.filter = filter;
  return makeDeepShadowMap(settings);
}

constexpr auto kUniform = DensityClusteringSettings::Start::Uniform;
constexpr auto kTowards = DensityClusteringSettings::Start::TowardsLight;
constexpr LateralFilter kFilters[] = {LateralFilter::Nearest, LateralFilter::Linear};
const Case kCases[] = {{"Clusters4", clustering<4, kUniform>},
                       {"Clusters1", clustering<1, kUniform>},
                       {"Clusters16TowardsLight", clustering<16, kTowards>},
                       {"DeepExact", deepShadowMap<0>, true},
                       {"DeepTolerant", deepShadowMap<20>}};

class ListMethod : public testing::TestWithParam<Case> {
 protected:
  static std::unique_ptr<ShadowMethod> make(LateralFilter filter = LateralFilter::Linear,
                                            float pixelSize = 3e-3f) {
    return GetParam().make(pixelSize, filter);
  }
  static std::vector<float> at(const ShadowMethod& method, std::span<const glm::vec3> points) {
    std::vector<float> out(points.size(), -1.0f);
    method.sample(points, out);
    return out;
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, ListMethod, testing::ValuesIn(kCases),
                         [](const auto& given) { return given.param.name; });

TEST_P(ListMethod, LiesBetweenDarkAndLight) {
  const StrandSet hair = headOfHair(2000, 20);
  for (LateralFilter filter : kFilters) {
    const auto method = make(filter);
    method->build(hair, {}, makeLightSpace(kSlanted));
    const auto t = at(*method, hair.points);
    for (float v : t) {
      ASSERT_GE(v, 0.0f);
      ASSERT_LE(v, 1.0f);
    }
    const auto [least, most] = std::minmax_element(t.begin(), t.end());
    EXPECT_LT(*least, 0.1f);
    EXPECT_GT(*most, 0.9f);
  }
}

TEST_P(ListMethod, NeverIncreasesAlongTheLight) {
  const StrandSet hair = headOfHair(1000, 20);
  for (LateralFilter filter : kFilters) {
    const auto method = make(filter);
    method->build(hair, {}, alongX());
    bool shadowed = false;
    for (std::uint32_t ray = 0; ray < 300; ++ray) {
      const glm::vec3 through = hair.points[ray * 97 % hair.pointCount()];
      std::vector<glm::vec3> points;
      for (int i = -600; i <= 600; ++i)
        points.push_back(through + glm::vec3(7.3e-4f * static_cast<float>(i), 0, 0));
      const auto t = at(*method, points);
      ASSERT_EQ(t.front(), 1.0f);
      for (std::size_t i = 1; i < t.size(); ++i) ASSERT_LE(t[i], t[i - 1]);
      shadowed |= t.back() < 0.5f;
    }
    EXPECT_TRUE(shadowed);
  }
}

TEST_P(ListMethod, PointsInFrontOfAllHairAndBesideItAreLit) {
  const StrandSet hair = headOfHair(500, 20);
  const Bounds box = bounds(hair.points);
  for (LateralFilter filter : kFilters) {
    const float pixelSize = 3e-3f;
    const auto method = make(filter, pixelSize);
    method->build(hair, {}, alongX());
    std::vector<glm::vec3> lit;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      const glm::vec3 u(uniform(i, 0), uniform(i, 1), uniform(i, 2));
      const glm::vec3 inside = box.lower + u * box.size();
      lit.push_back({box.lower.x - 1e-5f - (i % 2 ? 0.0f : u.x), inside.y, inside.z});
      lit.push_back({inside.x + 0.3f, box.upper.y + pixelSize * (1.6f + 200 * u.y), inside.z});
      lit.push_back({inside.x + 0.3f, inside.y, box.lower.z - pixelSize * (1.6f + 200 * u.z)});
    }
    for (float v : at(*method, lit)) ASSERT_EQ(v, 1.0f);
    const glm::vec3 behind(box.upper.x + 1, box.centre().y, box.centre().z);
    EXPECT_LT(at(*method, std::span(&behind, 1))[0], 0.5f);
  }
}

TEST_P(ListMethod, LinearIsThePixelAtItsMiddleAndTheMeanOfFourAtItsCorner) {
  const StrandSet hair = headOfHair(1000, 20);
  const LightSpace light = makeLightSpace(kSlanted);
  const auto nearest = make(LateralFilter::Nearest), linear = make(LateralFilter::Linear);
  nearest->build(hair, {}, light);
  linear->build(hair, {}, light);
  const LightImage image = makeLightImage(hair, light, 3e-3f);
  std::vector<glm::vec3> corners, middles;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto whole = [&](int lower, int size, std::uint32_t use) {
      return static_cast<float>(lower) + std::floor(uniform(i, use) * static_cast<float>(size));
    };
    const float depth = image.nearest + uniform(i, 1) * (image.farthest - image.nearest);
    const glm::vec3 corner(depth, whole(image.lower.x, image.size.x, 2),
                           whole(image.lower.y, image.size.y, 3));
    corners.push_back(image.frame.point(corner));
    for (glm::vec2 to : {glm::vec2(-0.5f, -0.5f), {0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}})
      middles.push_back(image.frame.point(corner + glm::vec3(0, to)));
  }
  const auto t = at(*linear, corners), own = at(*linear, middles), pixel = at(*nearest, middles);
  // Points go to world coordinates and back, and depths with them: a few may cross a step.
  std::size_t apart = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float* four = pixel.data() + 4 * i;
    const float mean = 0.25f * (four[0] + four[1] + four[2] + four[3]);
    apart += std::abs(t[i] - mean) > 1e-3f ? 1 : 0;
    for (std::size_t j = 4 * i; j < 4 * i + 4; ++j) apart += std::abs(own[j] - pixel[j]) > 1e-3f;
  }
  EXPECT_LT(apart, 10u);
}

TEST_P(ListMethod, OfNoHairIsAllLit) {
  const auto method = make();
  const std::vector<glm::vec3> points = {{0, 0, 0}, {1, -2, 3}, {1e6f, 0, -1e6f}};
  EXPECT_EQ(at(*method, points), std::vector<float>(3, 1.0f)) << "never built";
  method->build({}, {}, makeLightSpace(kSlanted));
  EXPECT_EQ(at(*method, points), std::vector<float>(3, 1.0f));
  // Emptied again after there was some.
  method->build(headOfHair(200, 10), {}, makeLightSpace(kSlanted));
  method->build({}, {}, makeLightSpace(kSlanted));
  EXPECT_EQ(at(*method, points), std::vector<float>(3, 1.0f));
}

TEST_P(ListMethod, HasTheSameBitsForAnyThreadCount) {
  const StrandSet hair = headOfHair(3000, 20);
  std::uint64_t first = 0;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const auto method = make();
    method->build(hair, {}, makeLightSpace(kSlanted));
    const auto t = at(*method, hair.points);
    StateHash hash;
    hash.add(std::span<const float>(t));
    if (threads == 1) first = hash.value();
    EXPECT_EQ(hash.value(), first) << threads << " threads";
  }
}

TEST_P(ListMethod, RebuiltIsTheSameAsNew) {
  const StrandSet hair = headOfHair(500, 20), other = headOfHair(900, 30, 0.3f, {0.1f, 0.2f, 0});
  const auto used = make(), fresh = make();
  used->build(other, {}, makeLightSpace({1, 0.1f, 0}));
  used->build(hair, {}, makeLightSpace(kSlanted));
  fresh->build(hair, {}, makeLightSpace(kSlanted));
  EXPECT_EQ(at(*used, hair.points), at(*fresh, hair.points));
  EXPECT_GT(fresh->bytes(), 10000u);
}

TEST_P(ListMethod, OfALightFarAwayIsThatOfParallelLight) {
  const StrandSet hair = headOfHair(10000, 20);
  const Fibre fibre = test::oneHair(8e-5f, 0.6f);
  const LightSpace parallel = makeLightSpace(kSlanted);
  const glm::vec3 way = glm::normalize(kSlanted);
  // The pivot is a corner of parallel light's pixels too.
  const LightSpace point = makePointLightSpace(-1e4f * way, glm::vec3(0));
  const auto a = make(), b = make();
  a->build(hair, fibre, parallel);
  b->build(hair, fibre, point);
  const auto t = at(*a, hair.points), u = at(*b, hair.points);
  EXPECT_LT(*std::min_element(t.begin(), t.end()), 0.1f) << "no shadow to compare";
  double mean = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    mean += std::abs(double{t[i]} - double{u[i]}) / static_cast<double>(t.size());
  EXPECT_LT(mean, 5e-4);
  if (!GetParam().exact) {
    // A sliver of a fragment that enters a pixel can be its first, from which clusters set out, or
    // end a piece sooner: such pixels are as far apart as either is from the truth.
    EXPECT_LT(largestDifference(t, u), 0.045f);
    return;
  }
  // Rays that meet at 10 km move fragments by some micrometres across the light, fibres that run
  // along it by a hundred in depth: right at a step a point may stand on its other side.
  std::vector<glm::vec3> before = hair.points, behind = hair.points;
  for (glm::vec3& p : before) p -= 1e-4f * way;
  for (glm::vec3& p : behind) p += 1e-4f * way;
  const auto t0 = at(*a, before), t1 = at(*a, behind);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t0[i] - t1[i] > 5e-4f) continue;
    ++compared;
    ASSERT_NEAR(t[i], u[i], 1e-3f);
  }
  EXPECT_GT(compared, t.size() / 2);
}

TEST_P(ListMethod, OfASlabOfRandomFibresTendsToExpMinusTau) {
  // Fibres across the light, evenly in depth from 0 to 0.1 m: behind depth x, exp(-10 x tau).
  const float width = 1e-5f, opacity = 0.6f, length = 0.02f, side = 0.1f, tau = 2;
  const auto count = static_cast<std::uint32_t>(tau * side * side / (width * opacity * length));
  StrandSet fibres;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 p = side * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2));
    const float turn = 6.2831853f * uniform(i, 3);
    const glm::vec3 half = 0.5f * length * glm::vec3(0, std::cos(turn), std::sin(turn));
    fibres.append(std::vector<glm::vec3>{p - half, p + half});
  }
  const auto method = make(LateralFilter::Nearest);
  method->build(fibres, test::oneHair(width, opacity), alongX());
  for (float x : {0.02f, 0.05f, 0.08f, 0.11f}) {
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 4000; ++i)
      points.push_back(
          {x, side * (0.15f + 0.7f * uniform(i, 5)), side * (0.15f + 0.7f * uniform(i, 6))});
    double mean = 0;
    for (float v : at(*method, points)) mean += double{v} / 4000;
    EXPECT_NEAR(mean, std::exp(-tau * std::min(x / side, 1.0f)), 0.006) << x;
  }
}

}  // namespace
}  // namespace hair

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/deep_shadow_map.h>
#include <libhair/shadow/methods/fragment_lists.h>
#include <libhair/shadow/methods/shadow_method.h>

#include "../fixture.h"
#include "ray.h"

namespace hair {
namespace {

using test::exactTransmittance;
using test::fragmentsOfGaussians;
using test::headOfHair;
using test::kSlanted;

using Vertices = std::vector<VisibilityVertex>;

Vertices compressed(const std::vector<PixelFragment>& fragments, float tolerance) {
  Vertices vertices;
  compressVisibility(fragments, tolerance, vertices);
  return vertices;
}

/// Right in front of and right behind every fragment, and between.
std::vector<float> tellingDepths(const std::vector<PixelFragment>& fragments) {
  std::vector<float> depths = {-1e9f, 1e9f};
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const float d = fragments[i].depth;
    depths.insert(depths.end(), {std::nextafter(d, -1e9f), d, std::nextafter(d, 1e9f)});
    if (i > 0) depths.push_back(0.5f * (d + fragments[i - 1].depth));
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

void expectWithin(const std::vector<PixelFragment>& fragments, float tolerance) {
  const Vertices vertices = compressed(fragments, tolerance);
  ASSERT_LE(vertices.size(), 2 * fragments.size());
  ASSERT_EQ(vertices.front().transmittance, 1.0f);
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    ASSERT_GE(vertices[v].depth, vertices[v - 1].depth);
    ASSERT_LE(vertices[v].transmittance, vertices[v - 1].transmittance);
    ASSERT_GE(vertices[v].transmittance, 0.0f);
  }
  float last = 1;
  for (float d : tellingDepths(fragments)) {
    const float t = transmittanceAt(vertices, d);
    ASSERT_NEAR(t, exactTransmittance(fragments, d), tolerance + 2e-6f)
        << "at " << d << " of " << fragments.size() << " fragments";
    ASSERT_LE(t, last);
    last = t;
  }
}

TEST(CompressedVisibility, StaysWithinTheToleranceEverywhere) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    // From steps larger than the tolerance to steps far below it.
    const float opticalDepth = std::exp2(static_cast<float>(seed % 9) - 3);
    auto fragments = fragmentsOfGaussians(1 + static_cast<int>(seed % 6), seed,
                                          1 + static_cast<int>(seed), opticalDepth);
    if (seed % 4 == 0)
      for (PixelFragment& f : fragments) f.depth = std::round(f.depth * 30) / 30;
    for (float tolerance : {0.0f, 0.001f, 0.01f, 0.05f, 0.3f, 1.0f})
      expectWithin(fragments, tolerance);
  }
}

TEST(CompressedVisibility, WithoutToleranceKeepsEveryStep) {
  const auto fragments = fragmentsOfGaussians(4, 11, 100, 3);
  EXPECT_EQ(compressed(fragments, 0).size(), 200u);
}

TEST(CompressedVisibility, OfNothingIsNothing) {
  EXPECT_TRUE(compressed({}, 0.1f).empty());
  EXPECT_EQ(transmittanceAt({}, 5), 1.0f);
}

TEST(CompressedVisibility, AppendsToWhatIsThere) {
  const auto fragments = fragmentsOfGaussians(4, 3);
  Vertices twice = compressed(fragments, 0.01f);
  const std::size_t once = twice.size();
  compressVisibility(fragments, 0.01f, twice);
  ASSERT_EQ(twice.size(), 2 * once);
  for (std::size_t v = 0; v < once; ++v) {
    EXPECT_EQ(twice[v].depth, twice[once + v].depth);
    EXPECT_EQ(twice[v].transmittance, twice[once + v].transmittance);
  }
}

TEST(CompressedVisibility, NeedsFewVerticesForASmoothFunction) {
  // 10000 fragments, exp(-5 s).
  std::vector<PixelFragment> fragments;
  for (int i = 0; i < 10000; ++i) fragments.push_back({1e-4f * static_cast<float>(i), 5e-4f});
  std::size_t last = SIZE_MAX;
  for (float tolerance : {0.001f, 0.003f, 0.01f, 0.03f, 0.1f}) {
    // A line stays within e of a curve over a length h of h² |f''| / 8 = 2 e; so pieces number
    // the integral of sqrt(|f''| / (16 e)), here 2 (1 - exp(-5/2)) / (4 sqrt(e)).
    const double free = 2 * (1 - std::exp(-2.5)) / (4 * std::sqrt(double{tolerance}));
    const std::size_t pieces = compressed(fragments, tolerance).size() - 1;
    EXPECT_GE(static_cast<double>(pieces), std::floor(free)) << tolerance;
    // Greedy ones begin where the last ended: at most about twice as many.
    EXPECT_LE(static_cast<double>(pieces), 2 * free + 2) << tolerance;
    EXPECT_LT(pieces, last);
    last = pieces;
  }
}

TEST(CompressedVisibility, OfAStraightFunctionIsOnePiece) {
  std::vector<PixelFragment> fragments;
  for (int i = 0; i < 500; ++i) {
    const double before = 1 - 1e-3 * i, after = 1 - 1e-3 * (i + 1);
    fragments.push_back({static_cast<float>(i), static_cast<float>(std::log(before / after))});
  }
  EXPECT_EQ(compressed(fragments, 0.002f).size(), 2u);
}

TEST(CompressedVisibility, BridgesStepsUpToTwiceTheTolerance) {
  // Steps of one and a half tolerances, which a line can pass, but not many in a row; and of three.
  std::vector<PixelFragment> low, high;
  for (int i = 0; i < 40; ++i) {
    const auto step = [&](double height) {
      return static_cast<float>(std::log((1 - height * i) / (1 - height * (i + 1))));
    };
    low.push_back({static_cast<float>(i), step(0.015)});
    high.push_back({static_cast<float>(i), step(0.024)});
  }
  EXPECT_LT(compressed(low, 0.01f).size(), 24u);
  EXPECT_EQ(compressed(high, 0.008f).size(), 80u);
}

TEST(DeepShadowMap, IsTheProductOverEachPixelWithinItsTolerance) {
  const StrandSet hair = headOfHair(300, 20);
  const Fibre fibre;
  const LightSpace light = makeLightSpace(kSlanted);
  for (Extinction extinction : {Extinction::Unbiased, Extinction::Published}) {
    DeepShadowMapSettings settings;
    settings.filter = LateralFilter::Nearest;
    settings.extinction = extinction;
    // All fragments in one list, as they come.
    const LightImage image = makeLightImage(hair, light, settings.pixelSize);
    std::vector<Fragment> all;
    for (std::size_t s = 0; s < hair.strandCount(); ++s)
      forFragments(hair.strand(s), fibre, extinction, image,
                   [&](const Fragment& fragment) { all.push_back(fragment); });
    std::vector<glm::vec3> points;
    const Bounds box = bounds(hair.points);
    for (std::uint32_t i = 0; i < 1500; ++i) {
      const glm::vec3 u(uniform(i, 1), uniform(i, 2), uniform(i, 3));
      points.push_back(i % 2 ? hair.points[i * 3 % hair.pointCount()] : box.lower + u * box.size());
    }
    std::vector<float> product(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec3 u = image.frame.cellCoordinates(points[i]);
      const int y = floorToInt(u.y), z = floorToInt(u.z);
      double t = 1;
      for (const Fragment& f : all)
        if (image.inside(y, z) && f.pixel == image.index(y, z) && f.depth < u.x)
          t *= std::exp(-double{f.opticalDepth});
      product[i] = static_cast<float>(t);
    }
    EXPECT_LT(*std::min_element(product.begin(), product.end()), 0.2f) << "no shadow to compare";
    for (float tolerance : {0.0f, 0.002f, 0.01f, 0.05f}) {
      settings.tolerance = tolerance;
      const auto map = makeDeepShadowMap(settings);
      map->build(hair, fibre, light);
      std::vector<float> t(points.size());
      map->sample(points, t);
      for (std::size_t i = 0; i < t.size(); ++i)
        ASSERT_NEAR(t[i], product[i], tolerance + 1e-5f) << tolerance;
    }
  }
}

TEST(DeepShadowMap, RefusesSettingsOutOfRange) {
  const auto refuses = [](float pixelSize, float tolerance) {
    DeepShadowMapSettings settings;
    settings.pixelSize = pixelSize;
    settings.tolerance = tolerance;
    EXPECT_THROW(makeDeepShadowMap(settings), Error) << pixelSize << " " << tolerance;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_NO_THROW(makeDeepShadowMap({}));
  refuses(0, 0.01f);
  refuses(-1, 0.01f);
  refuses(kNan, 0.01f);
  refuses(kInfinity, 0.01f);
  refuses(1e-3f, -1e-6f);
  refuses(1e-3f, kNan);
  refuses(1e-3f, kInfinity);
}

}  // namespace
}  // namespace hair

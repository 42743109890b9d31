#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/density_map.h>

#include "fixture.h"

namespace hair {
namespace {

using test::headOfHair;
using test::kSlanted;
using test::largestDifference;

constexpr float kCell = 4e-3f;
const Capsule kBall{{0.01f, -0.02f, 0.03f}, {0.01f, -0.02f, 0.03f}, 0.08f};

DensityMapSettings settings() {
  DensityMapSettings s;
  s.cells = 192;
  s.cellSize = kCell;
  return s;
}

/// What a point light or a parallel one sees: whether the ball is between it and p, and by how much
/// the ray passes it by (metres, negative: through it).
struct Passing {
  bool behind;
  float miss;
};
Passing passing(const LightSpace& light, glm::vec3 p) {
  const glm::vec3 way = light.directionAt(p), toBall = kBall.a - p;
  const float along = glm::dot(toBall, way);
  const bool lightTurnsItsBack = light.atPoint() && glm::dot(kBall.a - light.position(), way) < 0;
  if (lightTurnsItsBack) return {false, INFINITY};
  return {along < 0, glm::length(toBall - along * way) - kBall.radius};
}

std::vector<glm::vec3> pointsAround() {
  std::vector<glm::vec3> points;
  for (std::uint32_t i = 0; i < 20000; ++i)
    points.push_back(kBall.a +
                     0.5f * (glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.5f));
  return points;
}

const LightSpace kLights[] = {makeLightSpace(kSlanted), makeLightSpace({0, -1, 0}),
                              makePointLightSpace({0.3f, 0.4f, -0.2f}, {0, 0, 0}),
                              makePointLightSpace({0.01f, 0.16f, 0.03f}, {0, 0, 0})};

TEST(Occlude, ABallIsDarkBehindAndLitBeforeAndBeside) {
  const auto points = pointsAround();
  for (const LightSpace& light : kLights) {
    DensityMap map;
    clear(map, settings(), light);
    occlude(std::span(&kBall, 1), map);
    computeTransmittance(map);
    std::vector<float> t(points.size());
    sampleTransmittance(map, points, t);
    int dark = 0, lit = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Passing at = passing(light, points[i]);
      const float outside = glm::distance(points[i], kBall.a) - kBall.radius;
      if (outside < 0) continue;
      // A light nearer than its pivot sees smaller cells, one farther away larger ones.
      const float cell =
          kCell * std::max(1.0f, 1 + light.curvature *
                                         glm::dot(points[i] - light.pivot, light.direction()));
      if (at.behind && at.miss < -3 * cell) {
        ASSERT_LT(t[i], 1e-6f) << i;
        ++dark;
      } else if ((!at.behind && at.miss < -2 * cell) || at.miss > 2 * cell) {
        ASSERT_EQ(t[i], 1.0f) << i << " miss " << at.miss;
        ++lit;
      }
    }
    EXPECT_GT(dark, 200);
    EXPECT_GT(lit, 5000);
  }
}

TEST(Occlude, HairOnTheLitSideIsAsWithoutTheHead) {
  const StrandSet hair = headOfHair(2000, 12);
  const Capsule head{glm::vec3(0), glm::vec3(0), 0.088f};  // strands begin at 0.09
  const LightSpace light = makeLightSpace(kSlanted);
  std::vector<float> without =
      test::shadow(hair, settings(), light, *std::make_unique<DensityMap>());
  DensityMap map;
  clear(map, settings(), light);
  deposit(hair, {}, map);
  occlude(std::span(&head, 1), map);
  computeTransmittance(map);
  std::vector<float> with(hair.pointCount());
  sampleTransmittance(map, hair.points, with);
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const glm::vec3 p = hair.points[i];
    const float along = glm::dot(p, light.direction());
    const float miss = glm::length(p - along * light.direction()) - head.radius;
    if (along < 0 && std::abs(miss) > 2 * kCell) {
      ASSERT_EQ(with[i], without[i]) << i;
      ++lit;
    } else if (along > 0 && miss < -3 * kCell) {
      ASSERT_LT(with[i], 1e-6f) << i;
      ++dark;
    }
  }
  EXPECT_GT(lit, 1000);
  EXPECT_GT(dark, 300);
}

TEST(Occlude, WhatIsFarAwayDoesNotComeRoundAndWhatIsInFrontShadows) {
  const StrandSet hair = headOfHair(800, 12);
  const LightSpace light = makeLightSpace({0, -1, 0});
  DensityMap map;
  const auto transmittance = [&](std::vector<Capsule> things) {
    clear(map, settings(), light);
    deposit(hair, {}, map);
    occlude(things, map);
    computeTransmittance(map);
    EXPECT_FALSE(map.aliased());
    std::vector<float> t(hair.pointCount());
    sampleTransmittance(map, hair.points, t);
    return t;
  };
  const auto alone = transmittance({});
  // Legs below, a wall beside, all more than a map of 0.77 m away.
  EXPECT_EQ(largestDifference(alone, transmittance({{{0, -1.2f, 0}, {0, -2, 0.1f}, 0.1f},
                                                    {{1.5f, 1, 0}, {1.5f, -1, 0}, 0.2f}})),
            0.0f);
  const auto under = transmittance({{{0, 2, 0}, {0, 2, 0}, 0.6f}});
  EXPECT_EQ(*std::max_element(under.begin(), under.end()), 0.0f);
}

TEST(Occlude, NothingIsReadThatWasNotLit) {
  const StrandSet hair = headOfHair(20, 12);
  DensityMap map;
  clear(map, settings(), kLights[0]);
  deposit(hair, {}, map);
  std::vector<float> t(hair.pointCount());
  EXPECT_THROW(sampleTransmittance(map, hair.points, t), Error);
  computeTransmittance(map);
  sampleTransmittance(map, hair.points, t);
  occlude(std::span(&kBall, 1), map);
  EXPECT_THROW(sampleTransmittance(map, hair.points, t), Error);
}

TEST(Occlude, HasTheSameBitsForAnyThreadCount) {
  const auto points = pointsAround();
  std::vector<float> first;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    DensityMap map;
    clear(map, settings(), kLights[2]);
    occlude(std::span(&kBall, 1), map);
    computeTransmittance(map);
    std::vector<float> t(points.size());
    sampleTransmittance(map, points, t);
    if (first.empty()) first = t;
    EXPECT_EQ(largestDifference(first, t), 0.0f) << threads;
  }
}

}  // namespace
}  // namespace hair

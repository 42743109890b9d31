#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/flicker.h>
#include <tests/measure/scene.h>

namespace hair {
namespace {

constexpr std::size_t kPoints = 4000;

std::vector<LightSpace> lights(int steps = 20) {
  return turningLights(makeLightSpace({0.3f, -0.8f, 0.4f}), {0.1f, steps});
}

// Of transmittances that are functions of point and step.
Flicker flickerOfFunction(const std::vector<LightSpace>& all, double (*f)(std::uint32_t, int)) {
  int step = 0;
  return flickerOf(all, kPoints, [&](const LightSpace&, std::span<float> out) {
    for (std::uint32_t p = 0; p < out.size(); ++p) out[p] = static_cast<float>(f(p, step));
    ++step;
  });
}

TEST(Flicker, WhatDoesNotChangeUnderRotationDoesNotFlicker) {
  const Flicker f = flickerOfFunction(
      lights(), [](std::uint32_t p, int) { return static_cast<double>(uniform(p, 0)); });
  EXPECT_EQ(f.shimmer, 0);
  EXPECT_EQ(f.swim, 0);
}

TEST(Flicker, AnEvenChangeIsNoFlicker) {
  const Flicker f = flickerOfFunction(lights(), [](std::uint32_t p, int k) {
    return 0.5 + 0.01 * (static_cast<double>(uniform(p, 0)) - 0.5) * k;
  });
  EXPECT_LT(f.shimmer, 1e-7);
  EXPECT_LT(f.swim, 1e-7);
}

TEST(Flicker, OfIndependentNoiseIsItsStandardDeviation) {
  const Flicker f = flickerOfFunction(lights(), [](std::uint32_t p, int k) {
    return 0.02 * (static_cast<double>(uniform(p, static_cast<std::uint32_t>(k))) - 0.5) + 0.5;
  });
  const double deviation = 0.02 / std::sqrt(12.0);
  EXPECT_NEAR(f.shimmer / deviation, 1, 0.01);
  EXPECT_NEAR(f.swim / deviation, 1, 0.01);
}

TEST(Flicker, SlowWavesSwimButHardlyShimmer) {
  const Flicker f = flickerOfFunction(lights(), [](std::uint32_t p, int k) {
    return 0.5 + 0.05 * std::sin(0.3 * k + 6.28 * static_cast<double>(uniform(p, 0)));
  });
  EXPECT_GT(f.swim, 0.02);
  EXPECT_LT(f.shimmer, f.swim / 10);
}

TEST(Flicker, LightsTurnByWholeSteps) {
  for (const glm::vec3 way : {glm::vec3(0.3f, -0.8f, 0.4f), glm::vec3(0, -1, 0)}) {
    const auto all = turningLights(makeLightSpace(way), {0.5f, 10});
    ASSERT_EQ(all.size(), 11u);
    EXPECT_EQ(all.front().direction(), makeLightSpace(way).direction());
    for (std::size_t k = 1; k < all.size(); ++k) {
      const float across = glm::length(glm::cross(all[k - 1].direction(), all[k].direction()));
      EXPECT_NEAR(glm::degrees(std::asin(across)), 0.5f, 1e-4f);
    }
    const float whole = glm::length(glm::cross(all.front().direction(), all.back().direction()));
    EXPECT_NEAR(glm::degrees(std::asin(whole)), 5.0f, 1e-3f);
  }
}

TEST(Flicker, ALightAtAPointGoesRoundItsPivot) {
  const glm::vec3 pivot(0.1f, 0.2f, 0.3f);
  for (const LightSpace& light : turningLights(makePointLightSpace({1, 1, 1}, pivot), {1.0f, 5})) {
    EXPECT_TRUE(light.atPoint());
    EXPECT_EQ(light.pivot, pivot);
    EXPECT_NEAR(glm::distance(light.position(), pivot), glm::distance(glm::vec3(1), pivot), 1e-5f);
  }
}

TEST(Flicker, FineCellsThatFollowTheLightFlickerMoreThanCoarse) {
  const StrandSet hair = hangingHair();
  const auto points = chooseSamplePoints(hair, 300, 1);
  DensityMapSettings fine, coarse;
  fine.cells = 512, fine.cellSize = 0.5e-3f;
  coarse.cells = 64, coarse.cellSize = 6e-3f;
  const auto all = lights(6);
  EXPECT_GT(flickerOf(fine, hair, broadFibre(), all, points).shimmer,
            3 * flickerOf(coarse, hair, broadFibre(), all, points).shimmer);
}

TEST(Flicker, BadStepsAreErrors) {
  const LightSpace light = makeLightSpace({0, -1, 0});
  EXPECT_THROW(turningLights(light, {0.0f, 20}), Error);
  EXPECT_THROW(turningLights(light, {NAN, 20}), Error);
  EXPECT_THROW(turningLights(light, {0.1f, 1}), Error);
  EXPECT_THROW(flickerOf(std::vector<LightSpace>{light, light}, 1,
                         [](const LightSpace&, std::span<float>) {}),
               Error);
}

}  // namespace
}  // namespace hair

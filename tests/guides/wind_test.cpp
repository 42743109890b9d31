// The air that guides move in.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/guides/wind_test.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>
#include <libhair/motion/wind-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

void sines(const Lanes& turns, Lanes& out) {
  store(sineOfTurns(Floats(turns)), out);
}
void blowAt(const WindField& wind, const LaneVec3& p, LaneVec3& out) {
  store(blow(wind, p), out);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/guides/guide_strands.h>

#include "sphere_groom.h"

namespace hair {
namespace {

HWY_EXPORT(sines);
HWY_EXPORT(blowAt);

TEST(Wind, ItsSineIsRightToThreeTimesTenToTheMinusSeven) {
  for (std::uint32_t i = 0; i < 20000; ++i) {
    Lanes turns, got;
    for (std::uint32_t l = 0; l < kLanes; ++l)
      turns[l] = (i % 2 ? 1.0f : 1000.0f) * (uniform(i, l) - 0.5f);
    if (i == 0) turns = Lanes{0, 0.25f, 0.5f, 0.75f, 1, -0.25f, -0.5f, 1e5f, 0.125f};
    HWY_DYNAMIC_DISPATCH(sines)(turns, got);
    for (std::size_t l = 0; l < kLanes; ++l)
      ASSERT_NEAR(got[l], std::sin(2 * std::numbers::pi * static_cast<double>(turns[l])), 3e-7)
          << turns[l];
  }
}

TEST(Wind, SixteenPointsFeelWhatEachOfThemWould) {
  const Wind wind{{3, -1, 2}, 0.8f, 0.3f};
  for (std::uint32_t i = 0; i < 200; ++i) {
    const WindField field = wind.at(1000.0 * static_cast<double>(uniform(i, 0)));
    LaneVec3 p, got;
    for (std::uint32_t l = 0; l < kLanes; ++l)
      setLane(p, l, 4.0f * glm::vec3(uniform(i, l, 1), uniform(i, l, 2), uniform(i, l, 3)) - 2.0f);
    HWY_DYNAMIC_DISPATCH(blowAt)(field, p, got);
    for (std::size_t l = 0; l < kLanes; ++l)
      ASSERT_LT(glm::distance(lane(got, l), field.at(lane(p, l))), 1e-4f);
  }
}

TEST(Wind, GustsTravelWithTheFlowAndKeepWithinTheirSwing) {
  // One wave alone is carried unchanged; all together stay within gust of the speed along the flow.
  const Wind wind{{0, 0, 4}, 0.5f, 0.4f};
  for (std::uint32_t i = 0; i < 500; ++i) {
    const glm::vec3 p(uniform(i, 0), uniform(i, 1), uniform(i, 2));
    const double t = 3600.0 * static_cast<double>(uniform(i, 3)), later = t + 0.1;
    const glm::vec3 here = wind.at(t).at(p), there = wind.at(later).at(p + 0.1f * wind.velocity);
    ASSERT_LT(glm::distance(here, there), 2e-3f);
    ASSERT_GE(here.z, 2 - 1e-4f);
    ASSERT_LE(here.z, 6 + 1e-4f);
  }
}

TEST(Wind, StillAirIsStill) {
  const Wind wind;
  EXPECT_EQ(wind.at(17.0).at({1, 2, 3}), glm::vec3(0));
}

TEST(Wind, WhatHasHalfOfItOccludedLeansAsInHalfOfIt) {
  const auto tip = [](float speed, float share) {
    GuideStrands guides(test::oneStrand({0, -1, 0}, 0.3f, 15), {});
    GuideWorkspace workspace;
    const std::vector<Lanes> shares(guides.position.size(), lanes(share));
    GuideMotion motion;
    motion.wind.velocity = {speed, 0, 0};
    motion.wind.gust = 0;
    if (share < 1) motion.windShare = shares;
    for (int frame = 0; frame < 300; ++frame) stepGuides(motion, {}, 1.0f / 60, workspace, guides);
    return guides.point(0, 15);
  };
  EXPECT_LT(glm::distance(tip(4, 0.5f), tip(2, 1)), 1e-6f);
  EXPECT_GT(glm::distance(tip(4, 0.5f), tip(4, 1)), 0.01f);
}

}  // namespace
}  // namespace hair

#endif

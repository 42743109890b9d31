#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/rotations.h>
#include <libhair/motion/body.h>
#include <libhair/motion/clip_filter.h>

#include "clips.h"

namespace hair {
namespace {

/// One joint that turns at `degreesPerSecond`, 120 frames a second.
Clip spin(float degreesPerSecond, std::size_t frames = 60) {
  Clip clip = chainClip(1);
  for (std::size_t f = 0; f < frames; ++f) {
    clip.rotations.push_back(
        turned({0.1f, 1, 0}, degreesPerSecond * static_cast<float>(f) / 120.0f));
    clip.positions.emplace_back(0);
  }
  return clip;
}

float worstDifference(const Clip& a, const Clip& b) {
  float worst = 0;
  for (std::size_t i = 0; i < a.rotations.size(); ++i)
    worst = std::max(worst, degreesBetween(a.rotations[i], b.rotations[i]));
  return worst;
}

float maxHeadSpeed(const Clip& clip) {
  const auto head = static_cast<std::size_t>(mapBody(clip.skeleton).head);
  std::vector<RigidTransform> a(clip.skeleton.jointCount()), b(a);
  float worst = 0;
  poseAtFrame(clip, 0, a);
  for (std::size_t f = 1; f < clip.frameCount(); ++f) {
    poseAtFrame(clip, f, b);
    worst = std::max(worst, degreesBetween(a[head].rotation, b[head].rotation));
    std::swap(a, b);
  }
  return worst / static_cast<float>(clip.frameTime);
}

TEST(Flips, APlantedFlipIsFoundAndThePathIsAsBefore) {
  for (float speed : {0.0f, 90.0f, 1143.0f})
    for (int frames : {1, 2})
      for (float degrees : {4.0f, 15.0f, 170.0f}) {
        const Clip good = spin(speed);
        Clip bad = good;
        for (int i = 0; i < frames; ++i) {
          glm::quat& q = bad.rotations[static_cast<std::size_t>(30 + i)];
          q = q * turned({1, 0.3f, -0.2f}, degrees);
        }
        const std::vector<Flip> flips = removeFlips(bad);
        ASSERT_EQ(flips.size(), 1u) << speed << " deg/s, " << degrees << " deg";
        EXPECT_EQ(flips[0].frame, 30u);
        EXPECT_EQ(flips[0].frames, frames);
        EXPECT_NEAR(flips[0].degrees, degrees, 0.05f);
        EXPECT_LT(worstDifference(good, bad), 0.01f);
      }
}

TEST(Flips, FastSmoothMotionIsUntouched) {
  Clip clip = chainClip(1);
  for (std::size_t f = 0; f < 240; ++f) {
    // Up to 1500 deg/s and back within a second, then a nod of 3 Hz.
    const float t = static_cast<float>(f) / 120.0f;
    clip.rotations.push_back(
        turned({0, 1, 0}, 477.0f * (t - std::sin(6.2832f * t) / 6.2832f) * 1.57f) *
        turned({1, 0, 0}, 30.0f * std::sin(18.85f * t)));
    clip.positions.emplace_back(0);
  }
  const Clip before = clip;
  EXPECT_TRUE(removeFlips(clip).empty());
  EXPECT_EQ(clip.rotations, before.rotations);
}

TEST(Flips, AJumpThatStaysAndASharpTurnAreNoFlips) {
  Clip clip = spin(100.0f);
  for (std::size_t f = 30; f < 60; ++f)
    clip.rotations[f] = turned({1, 0, 0}, 40) * clip.rotations[f];
  for (std::size_t f = 45; f < 60; ++f)
    clip.rotations[f] = turned({0, 0, 1}, 6.0f * static_cast<float>(f - 44)) * clip.rotations[f];
  const Clip before = clip;
  EXPECT_TRUE(removeFlips(clip).empty());
  EXPECT_EQ(clip.rotations, before.rotations);
}

TEST(Flips, AJointThatKeepsShakingIsLeftAlone) {
  Clip clip = spin(100.0f);
  for (std::size_t f = 0; f < 60; f += 2)
    clip.rotations[f] = turned({1, 0, 0}, 4) * clip.rotations[f];
  EXPECT_TRUE(removeFlips(clip).empty());
}

TEST(Flips, FilteringTwiceChangesNothingMore) {
  SKIP_WITHOUT_CLIP("05_06");
  Clip clip = clipFromBvh(readBvh(realClip("05_06")));
  clip = trim(clip, 5, clip.frameCount());
  const std::size_t first = removeFlips(clip).size();
  EXPECT_GE(first, 10u);
  EXPECT_LE(removeFlips(clip).size(), first / 4);
}

TEST(Flips, RealSpikesGoAndRealPirouettesStay) {
  SKIP_WITHOUT_CLIP("05_11");
  SKIP_WITHOUT_CLIP("05_20");
  Clip pirouettes = clipFromBvh(readBvh(realClip("05_11")));
  pirouettes = trim(pirouettes, 5, pirouettes.frameCount());
  const Clip before = pirouettes;
  removeFlips(pirouettes);
  EXPECT_GT(maxHeadSpeed(pirouettes), 1100.0f);
  EXPECT_LT(worstDifference(before, pirouettes), 4.0f);  // what is replaced was a spike of 3 deg

  Clip jumps = clipFromBvh(readBvh(realClip("05_20")));
  jumps = trim(jumps, 5, jumps.frameCount());
  const std::vector<Flip> flips = removeFlips(jumps);
  const auto found = [&](std::size_t frame) {
    return std::any_of(flips.begin(), flips.end(), [&](const Flip& f) { return f.frame == frame; });
  };
  EXPECT_TRUE(found(778));
  EXPECT_TRUE(found(787));
}

}  // namespace
}  // namespace hair

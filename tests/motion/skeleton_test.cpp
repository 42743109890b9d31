#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/core/rotations.h>
#include <libhair/motion/motion.h>

#include "clips.h"

namespace hair {
namespace {

using Channel = Bvh::Channel;

/// Root and one child 1 unit above it; every joint has the same channels.
Bvh twoJoints(const std::vector<Channel>& channels, const std::vector<float>& values) {
  Bvh bvh;
  bvh.joints.resize(3);
  bvh.joints[0] = {"root", -1, {1, 2, 3}, channels, 0, false};
  bvh.joints[1] = {"child", 0, {0, 10, 0}, channels, static_cast<std::uint32_t>(channels.size()),
                   false};
  bvh.joints[2] = {"child end", 1, {0, 0, 7}, {}, 0, true};
  bvh.channelCount = 2 * channels.size();
  bvh.frameTime = 0.01;
  bvh.values = values;
  return bvh;
}

Clip randomClip(std::size_t joints, std::size_t frames) {
  Clip clip = chainClip(joints);
  clip.frameTime = 1.0 / 60.0;
  for (std::uint32_t i = 0; i < frames * joints; ++i) {
    const auto u = [&](std::uint32_t use) { return uniform(i, use) - 0.5f; };
    clip.rotations.push_back(glm::normalize(glm::quat(u(0), u(1), u(2), u(3))));
    clip.positions.push_back(i % joints == 0 ? glm::vec3(u(4), u(5), u(6))
                                             : clip.skeleton.offsets[i % joints]);
  }
  return clip;
}

TEST(Skeleton, AnyOrderOfAxesIsTheProductOfTurnsInTheOrderOfTheFile) {
  const std::array<Channel, 3> rotations = {Channel::Xrotation, Channel::Yrotation,
                                            Channel::Zrotation};
  const std::array<glm::vec3, 3> axes = {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}};
  std::array<std::size_t, 3> order = {0, 1, 2};
  const std::vector<float> angles = {20, -75, 130, 10, 200, -33};
  do {
    std::vector<Channel> channels;
    for (std::size_t i : order) channels.push_back(rotations[i]);
    const Clip clip = clipFromBvh(twoJoints(channels, angles));
    for (std::size_t j = 0; j < 2; ++j) {
      // Column vectors: the last channel acts first.
      glm::quat expected(1, 0, 0, 0);
      for (std::size_t i = 0; i < 3; ++i)
        expected = expected * turned(axes[order[i]], angles[3 * j + i]);
      EXPECT_LT(degreesBetween(clip.rotations[j], expected), 1e-3f);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Skeleton, PositionChannelsReplaceTheOffsetOnAnyJointAndUnitsBecomeMetres) {
  const Clip clip =
      clipFromBvh(twoJoints({Channel::Yposition, Channel::Zrotation}, {50, 90, 30, 0}), 0.01f);
  ASSERT_EQ(clip.skeleton.jointCount(), 2u);  // an end site is a tip, no joint
  EXPECT_EQ(clip.skeleton.tips[1], glm::vec3(0, 0, 0.07f));
  std::array<RigidTransform, 2> world;
  poseAtFrame(clip, 0, world);
  EXPECT_LT(glm::distance(world[0].translation, glm::vec3(0.01f, 0.5f, 0.03f)), 1e-6f);
  // Child: 0.3 m along the root's Y, which a quarter turn about Z lays along -X.
  EXPECT_LT(glm::distance(world[1].translation, glm::vec3(-0.29f, 0.5f, 0.03f)), 1e-6f);
}

TEST(Skeleton, NothingTurnedMeansOffsetsAddUp) {
  Clip clip = chainClip(5);
  clip.rotations.assign(5, glm::quat(1, 0, 0, 0));
  clip.positions = clip.skeleton.offsets;
  std::array<RigidTransform, 5> world;
  poseAtFrame(clip, 0, world);
  for (std::size_t j = 0; j < 5; ++j)
    EXPECT_NEAR(world[j].translation.y, 0.1f * static_cast<float>(j + 1), 1e-6f);
}

TEST(Skeleton, BonesKeepTheirLengthAtEveryTime) {
  const Clip clip = randomClip(6, 20);
  std::vector<RigidTransform> world(6);
  for (double t = -0.1; t < clip.duration() + 0.1; t += 0.0037) {
    poseAtTime(clip, t, world);
    for (std::size_t j = 1; j < 6; ++j)
      ASSERT_NEAR(glm::distance(world[j].translation, world[j - 1].translation), 0.1f, 1e-5f);
  }
}

TEST(Skeleton, AFramesOwnTimeGivesThatFrame) {
  const Clip clip = randomClip(4, 50);
  std::vector<RigidTransform> a(4), b(4);
  for (std::size_t f = 0; f < 50; ++f) {
    poseAtFrame(clip, f, a);
    poseAtTime(clip, static_cast<double>(f) * clip.frameTime, b);
    for (std::size_t j = 0; j < 4; ++j) {
      ASSERT_EQ(a[j].rotation, b[j].rotation);
      ASSERT_EQ(a[j].translation, b[j].translation);
    }
  }
}

TEST(Skeleton, PosesAreContinuousAcrossFrames) {
  const Clip clip = randomClip(4, 50);
  std::vector<RigidTransform> a(4), b(4);
  for (std::size_t f = 1; f < 49; ++f) {
    const double t = static_cast<double>(f) * clip.frameTime;
    poseAtTime(clip, t - 1e-5, a);
    poseAtTime(clip, t + 1e-5, b);
    for (std::size_t j = 0; j < 4; ++j)
      ASSERT_LT(glm::distance(a[j].translation, b[j].translation), 2e-3f);
  }
}

TEST(Skeleton, ResamplingAtItsOwnRateChangesNoBit) {
  const Clip clip = randomClip(3, 100);
  const Clip same = resample(clip, clip.frameTime);
  EXPECT_EQ(same.rotations, clip.rotations);
  EXPECT_EQ(same.positions, clip.positions);
}

TEST(Skeleton, ResamplingToTwiceTheRateKeepsEverySecondFrame) {
  const Clip clip = randomClip(3, 40);
  const Clip twice = resample(clip, clip.frameTime / 2);
  ASSERT_EQ(twice.frameCount(), 79u);
  for (std::size_t f = 0; f < 40; ++f)
    for (std::size_t j = 0; j < 3; ++j)
      ASSERT_EQ(twice.rotations[2 * f * 3 + j], clip.rotations[f * 3 + j]);
  EXPECT_NEAR(twice.duration(), clip.duration(), 1e-9);
}

TEST(Skeleton, TrimmingKeepsTheFramesNamed) {
  const Clip clip = randomClip(3, 40);
  const Clip part = trim(clip, 5, 9);
  ASSERT_EQ(part.frameCount(), 4u);
  EXPECT_EQ(part.rotations[0], clip.rotations[15]);
  EXPECT_EQ(part.positions[11], clip.positions[26]);
  EXPECT_THROW(trim(clip, 9, 9), Error);
  EXPECT_THROW(trim(clip, 0, 41), Error);
}

TEST(Skeleton, BadInputIsRefusedWithItsCause) {
  Bvh bvh = twoJoints({Channel::Zrotation}, {});
  EXPECT_THROW(clipFromBvh(bvh), Error);  // no frames
  bvh.values = {0, 0};
  EXPECT_THROW(clipFromBvh(bvh, 0.0f), Error);
  bvh.frameTime = 0;
  EXPECT_THROW(clipFromBvh(bvh), Error);
  EXPECT_THROW(resample(randomClip(2, 3), -1.0), Error);
  // Bones of a light year, of which no radius of a capsule can be told.
  bvh.frameTime = 1.0f / 30;
  EXPECT_NO_THROW(clipFromBvh(bvh));
  bvh.joints[1].offset.x = 1e20f;
  try {
    clipFromBvh(bvh);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(bvh.joints[1].name), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("check the scale"), std::string::npos);
  }
}

TEST(LeadIn, AJumpFromACalibrationPoseIsSeenAndASteadyStartIsNot) {
  for (std::size_t jumps : {0u, 1u, 4u}) {
    Clip clip = chainClip(6);
    for (std::size_t f = 0; f < 80; ++f)
      for (std::size_t j = 0; j < 6; ++j) {
        const float away = f < jumps ? 8.0f * static_cast<float>(jumps - f) : 0.0f;
        clip.rotations.push_back(
            turned({1, 0.2f * static_cast<float>(j), 0}, away + 0.4f * static_cast<float>(f)));
        clip.positions.push_back(clip.skeleton.offsets[j]);
      }
    EXPECT_EQ(leadInFrames(clip), jumps);
  }
}

TEST(LeadIn, RealRecordingsOpenWithFiveFramesOrNone) {
  for (const std::string& name : kRealClips) {
    SKIP_WITHOUT_CLIP(name);
    const Clip clip = clipFromBvh(readBvh(realClip(name)));
    EXPECT_EQ(leadInFrames(clip), name == "jesse_dance" ? 0u : 5u) << name;
  }
}

}  // namespace
}  // namespace hair

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/rotations.h>
#include <libhair/motion/clip_filter.h>
#include <libhair/motion/dance.h>
#include <libhair/motion/motion.h>

namespace hair {
namespace {

const Motion& dance() {
  static const Motion motion = Motion::dance();
  return motion;
}

std::size_t joint(const char* name) {
  const auto& names = dance().clip().skeleton.names;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(Dance, LastsFifteenSecondsAndEndsAsItStarts) {
  const Clip& clip = dance().clip();
  EXPECT_NEAR(clip.duration(), 15.0, 1e-9);
  const std::size_t n = clip.skeleton.jointCount(), last = clip.frameCount() - 1;
  for (std::size_t j = 0; j < n; ++j) {
    EXPECT_LT(degreesBetween(clip.rotations[j], clip.rotations[last * n + j]), 1e-3f);
    EXPECT_LT(glm::distance(clip.positions[j], clip.positions[last * n + j]), 1e-6f);
    // And the seam is as smooth as the rest: speed changes no faster there.
    const auto bend = [&](std::size_t before, std::size_t at, std::size_t after) {
      const auto q = [&](std::size_t f) { return clip.rotations[f * n + j]; };
      return degreesBetween(glm::normalize(glm::slerp(q(before), q(after), 0.5f)), q(at));
    };
    float worst = 0;
    for (std::size_t f = 1; f < last; ++f) worst = std::max(worst, bend(f - 1, f, f + 1));
    EXPECT_LE(bend(last - 1, last, 1), std::max(worst, 0.05f)) << clip.skeleton.names[j];
  }
}

TEST(Dance, BonesKeepTheirLength) {
  const Clip& clip = dance().clip();
  for (std::size_t i = 0; i < clip.positions.size(); ++i)
    if (const std::size_t j = i % clip.skeleton.jointCount(); j > 0) {
      ASSERT_EQ(clip.positions[i], clip.skeleton.offsets[j]);
    }
}

TEST(Dance, StandingFeetDoNotSkateAndNoFootSinks) {
  const Clip& clip = dance().clip();
  std::vector<RigidTransform> a(clip.skeleton.jointCount()), b(a);
  for (const char* name : {"LeftToeBase", "RightToeBase"}) {
    const std::size_t ball = joint(name);
    std::size_t standing = 0;
    poseAtFrame(clip, 0, a);
    for (std::size_t f = 1; f < clip.frameCount(); ++f) {
      poseAtFrame(clip, f, b);
      const glm::vec3 p = a[ball].translation, q = b[ball].translation;
      ASSERT_GT(q.y, 0.02f - 0.003f) << name << " frame " << f;
      if (p.y < 0.0203f && q.y < 0.0203f) {
        ++standing;
        ASSERT_LT(glm::distance(p, q), 0.0015f) << name << " frame " << f;
      }
      std::swap(a, b);
    }
    EXPECT_GT(standing, clip.frameCount() / 2) << name;
  }
}

TEST(Dance, OneFootIsOnTheFloorAtAnyTime) {
  const Clip& clip = dance().clip();
  std::vector<RigidTransform> pose(clip.skeleton.jointCount());
  for (std::size_t f = 0; f < clip.frameCount(); ++f) {
    poseAtFrame(clip, f, pose);
    ASSERT_LT(std::min(pose[joint("LeftToeBase")].translation.y,
                       pose[joint("RightToeBase")].translation.y),
              0.025f)
        << "frame " << f;
  }
}

TEST(Dance, SpinsFasterThanFiveHundredDegreesASecondAndOneAndAHalfTimesRound) {
  const double dt = 1.0 / 120.0;
  float fastest = 0, spun = 0;
  BodyPose before = dance().pose(0), after;
  for (double t = dt; t <= 15.0; t += dt) {
    dance().pose(t, after);
    const float degrees =
        degreesBetween(before.worldFromHead.rotation, after.worldFromHead.rotation);
    fastest = std::max(fastest, degrees / static_cast<float>(dt));
    // About the vertical, in the seconds of the spin.
    const glm::vec3 face = before.worldFromHead.vector({0, 0, 1});
    const glm::vec3 next = after.worldFromHead.vector({0, 0, 1});
    if (t > 7.2 && t < 8.7)
      spun += glm::degrees(std::atan2(glm::cross(face, next).y, glm::dot(face, next)));
    std::swap(before, after);
  }
  EXPECT_GT(fastest, 500.0f);
  EXPECT_LT(fastest, 1000.0f);
  EXPECT_NEAR(spun, 540.0f, 70.0f);
}

TEST(Dance, NodsLeansAndBows) {
  float down = 1, up = -1, left = 1, right = -1;
  for (double t = 0; t < 15.0; t += 0.01) {
    const RigidTransform head = dance().pose(t).worldFromHead;
    down = std::min(down, head.vector({0, 0, 1}).y);
    up = std::max(up, head.vector({0, 0, 1}).y);
    left = std::min(left, head.vector({1, 0, 0}).y);
    right = std::max(right, head.vector({1, 0, 0}).y);
  }
  EXPECT_LT(down, -0.9f);  // looks at the floor
  EXPECT_GT(up, 0.5f);     // and up, after the flip
  EXPECT_LT(left, -0.4f);
  EXPECT_GT(right, 0.4f);
}

TEST(Dance, IsSmooth) {
  Clip clip = danceClip();
  EXPECT_TRUE(removeFlips(clip).empty());
}

TEST(Dance, IsTheSameAtAnyFrameRate) {
  const Motion other(danceClip(1.0 / 60.0));
  for (double t = 0; t < 15.0; t += 0.25) {
    const RigidTransform a = dance().pose(t).worldFromHead, b = other.pose(t).worldFromHead;
    ASSERT_LT(glm::distance(a.translation, b.translation), 1e-4f);
    ASSERT_LT(degreesBetween(a.rotation, b.rotation), 1e-2f);
  }
}

}  // namespace
}  // namespace hair

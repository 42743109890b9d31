#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/motion/body_colliders.h>
#include <libhair/motion/dance.h>
#include <libhair/motion/head_motion.h>
#include <libhair/motion/motion.h>

#include "clips.h"

namespace hair {
namespace {

constexpr glm::vec3 kUp(0, 1, 0), kFront(0, 0, 1);

float degreesApart(glm::vec3 a, glm::vec3 b) {
  return glm::degrees(
      std::acos(glm::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.f, 1.f)));
}

std::vector<std::pair<std::string, Motion>> allMotions() {
  std::vector<std::pair<std::string, Motion>> motions;
  motions.emplace_back("dance", Motion::dance());
  motions.emplace_back("still", Motion::still());
  for (const std::string& name : kRealClips)
    if (std::filesystem::exists(realClip(name)))
      motions.emplace_back(name, Motion(clipFromBvh(readBvh(realClip(name)))));
  return motions;
}

/// The dancer's skeleton with its local frames turned at random: same body, another rig.
Clip reRigged(const Clip& clip) {
  Clip out = clip;
  const std::size_t joints = clip.skeleton.jointCount();
  std::vector<glm::quat> turn;
  for (std::size_t j = 0; j < joints; ++j)
    turn.push_back(turned({0, 0, 1}, 90.0f * static_cast<float>(j % 3 + 1)) *
                   turned({1, 0, 0}, 90.0f * static_cast<float>(j % 4)));
  const auto parentTurn = [&](std::size_t j) {
    const int p = clip.skeleton.parents[j];
    return p < 0 ? glm::quat(1, 0, 0, 0) : turn[static_cast<std::size_t>(p)];
  };
  for (std::size_t j = 0; j < joints; ++j) {
    out.skeleton.offsets[j] = glm::conjugate(parentTurn(j)) * clip.skeleton.offsets[j];
    out.skeleton.tips[j] = glm::conjugate(turn[j]) * clip.skeleton.tips[j];
    for (std::size_t f = 0; f < clip.frameCount(); ++f) {
      const std::size_t i = f * joints + j;
      out.rotations[i] = glm::conjugate(parentTurn(j)) * clip.rotations[i] * turn[j];
      out.positions[i] = glm::conjugate(parentTurn(j)) * clip.positions[i];
    }
  }
  return out;
}

TEST(Body, JointsAreKnownInTheCommonConventions) {
  for (const auto& [name, motion] : allMotions()) {
    const BodyMap& map = motion.body().map;
    EXPECT_TRUE(map.complete()) << name;
    const auto at = [&, &m = motion](int j) {
      return m.body().rest[static_cast<std::size_t>(j)].translation;
    };
    for (std::size_t s = 0; s < 2; ++s) {
      const float x = s == 0 ? 1.0f : -1.0f;
      EXPECT_GT(x * at(map.hand[s]).x, 0.3f) << name;
      EXPECT_GT(x * at(map.foot[s]).x, 0.02f) << name;
      EXPECT_LT(at(map.shin[s]).y, at(map.thigh[s]).y) << name;
      EXPECT_LT(at(map.foot[s]).y, at(map.shin[s]).y) << name;
    }
    EXPECT_GT(at(map.head).y, at(map.neck).y) << name;
    EXPECT_GT(at(map.neck).y, at(map.chest).y) << name;
    EXPECT_GT(motion.body().size, 0.9f) << name;
    EXPECT_LT(motion.body().size, 1.2f) << name;
  }
}

TEST(Body, SidesAreReadFromLettersAndWords) {
  Skeleton s;
  const auto add = [&](const char* name, int parent) {
    s.names.emplace_back(name);
    s.parents.push_back(parent);
    s.offsets.emplace_back(0, 0.1f, 0);
    s.tips.emplace_back(0);
  };
  add("mixamorig:Hips", -1);
  add("mixamorig:Spine", 0);
  add("mixamorig:Neck", 1);
  add("mixamorig:HEAD", 2);
  add("L_UpperArm", 1);
  add("L_ForeArm", 4);
  add("L_Hand", 5);
  add("upperarm.R", 1);
  add("forearm.R", 7);
  add("hand.R", 8);
  add("lThigh", 0);
  add("lShin", 10);
  add("lFoot", 11);
  add("RightUpLeg", 0);
  add("RightLeg", 13);
  add("RightFoot", 14);
  const BodyMap map = mapBody(s);
  EXPECT_TRUE(map.complete());
  EXPECT_EQ(map.head, 3);
  EXPECT_EQ(map.hand[0], 6);
  EXPECT_EQ(map.hand[1], 9);
  EXPECT_EQ(map.foot[0], 12);
  EXPECT_EQ(map.foot[1], 15);
  EXPECT_EQ(map.chest, 1);
  EXPECT_EQ(map.collar[0], -1);
}

TEST(Head, FacesWhereTheBodyFacesAndStandsUpOnAverage) {
  for (const auto& [name, motion] : allMotions()) {
    glm::vec3 face(0), up(0);
    int poses = 0;
    for (double t = 0; t <= motion.duration(); t += 0.02, ++poses) {
      const BodyPose pose = motion.pose(t);
      const glm::vec3 facing = bodyFacing(motion.body().map, pose.worldFromJoint);
      // Seen from the trunk, so that turns of the whole body do not average out.
      const glm::vec3 spine =
          pose.worldFromJoint[static_cast<std::size_t>(motion.body().map.neck)].translation -
          pose.worldFromJoint[static_cast<std::size_t>(motion.body().map.hips)].translation;
      const glm::quat trunk = rotationFromUpFront(spine, facing);
      face += glm::conjugate(trunk) * pose.worldFromHead.vector(kFront);
      up += glm::conjugate(trunk) * pose.worldFromHead.vector(kUp);
    }
    // 05_06 looks aside for most of its seven seconds; the others look ahead.
    EXPECT_LT(degreesApart({face.x, 0, face.z}, kFront), name == "05_06" ? 30.0f : 15.0f) << name;
    RecordProperty(name + "_face_degrees",
                   std::to_string(degreesApart({face.x, 0, face.z}, kFront)));
    RecordProperty(name + "_up_degrees", std::to_string(degreesApart(up, kUp)));
    EXPECT_GT(glm::length(face) / static_cast<float>(poses), 0.7f) << name;
    EXPECT_LT(degreesApart(up, kUp), 25.0f) << name;
  }
}

TEST(Head, HeadSpaceDoesNotDependOnTheRig) {
  const Clip clip = danceClip(1.0 / 30.0);
  const Clip other = reRigged(clip);
  const Body a = makeBody(clip), b = makeBody(other);
  EXPECT_TRUE(a.notes.empty());
  EXPECT_FALSE(b.notes.empty());  // its zero pose stands no longer
  std::vector<RigidTransform> poseA(a.skeleton.jointCount()), poseB(poseA);
  for (std::size_t f = 0; f < clip.frameCount(); f += 10) {
    poseAtFrame(clip, f, poseA);
    poseAtFrame(other, f, poseB);
    const RigidTransform headA = worldFromHead(a, poseA), headB = worldFromHead(b, poseB);
    ASSERT_LT(glm::distance(headA.translation, headB.translation), 1e-4f);
    ASSERT_LT(degreesBetween(headA.rotation, headB.rotation), 1.0f);
  }
  // Capsules too: the trunk is known from the bones and the facing.
  ASSERT_EQ(a.capsules.size(), b.capsules.size());
  std::vector<Capsule> ca(a.capsules.size()), cb(ca);
  placeCapsules(a, poseA, ca);
  placeCapsules(b, poseB, cb);
  for (std::size_t c = 0; c < ca.size(); ++c)
    EXPECT_LT(std::max(glm::distance(ca[c].a, cb[c].a), glm::distance(ca[c].b, cb[c].b)), 0.06f)
        << c;
}

TEST(Colliders, MoveContinuouslyAndKeepTheirCount) {
  for (const auto& [name, motion] : allMotions()) {
    const std::size_t count = motion.pose(0).capsules.size();
    EXPECT_GT(count, 20u);
    // Four steps a frame: whatever the frame moves, no step takes nearly all of it.
    std::array<BodyPose, 5> poses;
    const double frame = motion.clip().frameTime;
    for (double t = 0; t + frame <= motion.duration(); t += frame) {
      for (std::size_t k = 0; k < 5; ++k)
        motion.pose(t + static_cast<double>(k) * frame / 4.0, poses[k]);
      for (std::size_t c = 0; c < count; ++c) {
        // Only where an arm presses against something does it change its width, and not at once.
        ASSERT_NEAR(poses[0].capsules[c].radius, poses[4].capsules[c].radius,
                    glm::distance(poses[0].capsules[c].a, poses[4].capsules[c].a) +
                        glm::distance(poses[0].capsules[c].b, poses[4].capsules[c].b) + 0.05f);
        float sum = 0, most = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const Capsule &a = poses[k].capsules[c], &b = poses[k + 1].capsules[c];
          const float step = glm::distance(a.a, b.a) + glm::distance(a.b, b.b);
          sum += step;
          most = std::max(most, step);
        }
        ASSERT_LT(most, 0.75f * sum + 2e-4f) << name << " capsule " << c << " at " << t << " s";
      }
    }
  }
}

TEST(Colliders, OfTheDanceMoveNoFasterThanADancer) {
  const Motion motion = Motion::dance();
  BodyPose before = motion.pose(0), after;
  float fastest = 0;
  for (double t = 0.005; t <= motion.duration(); t += 0.005) {
    motion.pose(t, after);
    for (std::size_t c = 0; c < before.capsules.size(); ++c)
      fastest =
          std::max(fastest, glm::distance(before.capsules[c].b, after.capsules[c].b) / 0.005f);
    std::swap(before, after);
  }
  EXPECT_GT(fastest, 3.0f);
  EXPECT_LT(fastest, 10.0f);
}

TEST(Colliders, NothingReachesIntoTheSkull) {
  for (const auto& [name, motion] : allMotions()) {
    const BodyPose pose = motion.pose(0);
    const float s = motion.body().size;
    for (const BodyCapsule& c : motion.body().capsules) {
      // Rest stance: arms are down or out, so what is near the head is neck and shoulder.
      const auto top = [&, &m = motion](int j, glm::vec3 p) {
        return m.body().rest[static_cast<std::size_t>(j)].point(p).y + c.radius;
      };
      const float head =
          motion.body().rest[static_cast<std::size_t>(motion.body().map.head)].translation.y;
      EXPECT_LT(std::max(top(c.jointA, c.a), top(c.jointB, c.b)) - head, 0.055f * s) << name;
    }
  }
}

TEST(Colliders, TheTrunkIsWideAndTheNeckThin) {
  const Motion motion = Motion::still();
  const BodyPose pose = motion.pose(0);
  const auto inside = [&](glm::vec3 p) {
    for (const Capsule& c : pose.capsules) {
      const glm::vec3 axis = c.b - c.a;
      const float l2 = glm::dot(axis, axis);
      const float t = l2 > 0 ? glm::clamp(glm::dot(p - c.a, axis) / l2, 0.0f, 1.0f) : 0.0f;
      if (glm::distance(p, c.a + t * axis) < c.radius) return true;
    }
    return false;
  };
  const glm::vec3 head = pose.worldFromHead.translation;
  for (float side : {-1.0f, 1.0f}) {
    EXPECT_TRUE(inside(head + glm::vec3(0.12f * side, -0.17f, 0)));   // shoulder
    EXPECT_TRUE(inside(head + glm::vec3(0.12f * side, -0.30f, 0)));   // ribs
    EXPECT_FALSE(inside(head + glm::vec3(0.08f * side, -0.02f, 0)));  // beside the neck
    EXPECT_FALSE(inside(head + glm::vec3(0.16f * side, -0.06f, 0)));  // over the shoulder
  }
  EXPECT_TRUE(inside(head + glm::vec3(0, -0.05f, -0.03f)));
}

TEST(Colliders, AnUnknownSkeletonGetsACapsuleABoneAndANote) {
  Clip clip = chainClip(4);
  clip.skeleton.names[3] = "HEAD";
  clip.rotations.assign(4, glm::quat(1, 0, 0, 0));
  clip.positions = clip.skeleton.offsets;
  const Motion motion(clip);
  EXPECT_EQ(motion.body().notes.size(), 1u);
  EXPECT_EQ(motion.pose(0).capsules.size(), 3u);
  EXPECT_LT(degreesApart(motion.pose(0).worldFromHead.vector(kUp), kUp), 1e-2f);
  clip.skeleton.names[3] = "box";
  EXPECT_THROW(Motion{clip}, Error);
}

TEST(Motion, PosesWithoutAllocationOnceSized) {
  const Motion motion = Motion::dance();
  BodyPose pose = motion.pose(0);
  const auto* joints = pose.worldFromJoint.data();
  const auto* capsules = pose.capsules.data();
  motion.pose(3.21, pose);
  EXPECT_EQ(pose.worldFromJoint.data(), joints);
  EXPECT_EQ(pose.capsules.data(), capsules);
}

TEST(Motion, HoldsItsEndsOrGoesRound) {
  Clip clip = danceClip();
  const Motion once(trim(clip, 0, 400));
  const auto same = [](const BodyPose& a, const BodyPose& b) {
    return glm::distance(a.worldFromHead.translation, b.worldFromHead.translation) < 1e-5f &&
           degreesBetween(a.worldFromHead.rotation, b.worldFromHead.rotation) < 1e-2f;
  };
  EXPECT_TRUE(same(once.pose(-1), once.pose(0)));
  EXPECT_TRUE(same(once.pose(99), once.pose(once.duration())));
  const Motion dance = Motion::dance();
  EXPECT_TRUE(dance.isLoop());
  EXPECT_TRUE(same(dance.pose(1.5), dance.pose(1.5 + 3 * dance.duration())));
  EXPECT_TRUE(same(dance.pose(-1), dance.pose(dance.duration() - 1)));
  EXPECT_EQ(Motion::still().duration(), 0.0);
}

TEST(Motion, TheFloorIsUnderTheFeet) {
  for (const auto& [name, motion] : allMotions()) {
    int poses = 0, sunk = 0;
    for (double t = 0; t <= motion.duration(); t += 0.05, ++poses) {
      float lowest = 1e9f;
      for (const Capsule& c : motion.pose(t).capsules)
        lowest = std::min(lowest, std::min(c.a.y, c.b.y) - c.radius);
      sunk += lowest < motion.floorHeight() - 0.005f ? 1 : 0;
    }
    EXPECT_LT(sunk, poses * 0.15 + 1) << name;
    EXPECT_NEAR(motion.floorHeight(), 0.0f, 0.15f) << name;
  }
  EXPECT_NEAR(Motion::still().floorHeight(), 0.0f, 0.03f);
  EXPECT_NEAR(Motion::dance().floorHeight(), 0.0f, 0.03f);
}

TEST(Motion, ABadRangeIsRefused) {
  MotionSettings settings;
  settings.firstFrame = 300;
  settings.lastFrame = 200;
  EXPECT_THROW(Motion(danceClip(), settings), Error);
}

}  // namespace
}  // namespace hair

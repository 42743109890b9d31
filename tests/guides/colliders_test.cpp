// Guides among colliders of every kind: planes, capsules, meshes.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/guide_strands.h>

#include "ball.h"
#include "sphere_groom.h"

namespace hair {
namespace {

using test::ballSdf;
using test::meshAt;

enum class Kind { Plane, Capsule, Mesh };
constexpr Kind kKinds[] = {Kind::Plane, Kind::Capsule, Kind::Mesh};
constexpr float kRadius = 0.1f, kHalfLength = 0.1f;

const char* nameOf(Kind kind) {
  return kind == Kind::Plane ? "plane" : kind == Kind::Capsule ? "capsule" : "mesh";
}

// A collider with its highest place at `top`: a plane, or a bar along z.
struct Collider {
  std::vector<Plane> planes;
  std::vector<Capsule> capsules;
  std::vector<MeshCollider> meshes;

  Collider(Kind kind, glm::vec3 top, float size = 1) {
    static const auto sdf = test::barSdf(kRadius, kHalfLength);
    const glm::vec3 middle = top - glm::vec3(0, size * kRadius, 0);
    if (kind == Kind::Plane) planes.push_back({top, {0, 1, 0}});
    const glm::vec3 along(0, 0, size * kHalfLength);
    if (kind == Kind::Capsule) capsules.push_back({middle - along, middle + along, size * kRadius});
    if (kind == Kind::Mesh) meshes.push_back(meshAt(*sdf, middle, size));
  }
  Scenery scenery() const { return {planes, meshes}; }
};

GuideMotion motionOf(const RigidTransform& head, const Collider& before, const Collider& now) {
  GuideMotion motion{head, now.capsules, before.capsules};
  motion.scenery = now.scenery();
  motion.sceneryBefore = before.scenery();
  return motion;
}

float heightOver(Kind kind, const Collider& collider, glm::vec3 p) {
  if (kind == Kind::Plane) return distanceAndGradient(collider.planes[0], p).w;
  if (kind == Kind::Capsule) return distanceAndGradient(collider.capsules[0], p).w;
  return distanceAndGradient(collider.meshes[0], p).w;
}

// A strand that lies on the collider's top with its weight.
GuideStrands lyingStrand(const GuideSettings& settings) {
  Groom groom = test::oneStrand({1, 0, 0}, 0.15f, 15);
  for (glm::vec3& p : groom.guidePoints) p += glm::vec3(-0.075f, settings.skin, 0);
  GuideSettings weightless = settings;
  weightless.gravity = glm::vec3(0);
  return GuideStrands(groom, weightless);
}

TEST(Colliders, FrictionHoldsOnEachKindWhatASmoothOneLetsSlide) {
  // The collider moves sideways, by 3 cm in all, under a strand whose root stays.
  for (const Kind kind : kKinds) {
    const auto carried = [&](float friction) {
      GuideSettings settings;
      settings.friction = friction;
      settings.airDrag = 0;
      settings.bendingStiffness = 1e-12f;
      GuideStrands guides = lyingStrand(settings);
      GuideWorkspace workspace;
      Collider before(kind, {0, 0, 0});
      for (int frame = 1; frame <= 60; ++frame) {
        const Collider now(kind, {0, 0, 0.0005f * static_cast<float>(frame)});
        stepGuides(motionOf({}, before, now), settings, 1.0f / 60, workspace, guides);
        before = now;
      }
      return guides.point(0, 8).z;
    };
    EXPECT_LT(std::abs(carried(0)), 1e-3f) << nameOf(kind);
    EXPECT_GT(carried(2), 0.02f) << nameOf(kind);
    EXPECT_LT(carried(2), 0.031f) << nameOf(kind);
  }
}

TEST(Colliders, PointsStayOutOfEachKindWhileEverythingMoves) {
  const GuideSettings settings;
  for (const Kind kind : kKinds) {
    GuideStrands guides(test::sphereGroom(96, 16), settings);
    GuideWorkspace workspace;
    const auto at = [&](int frame) {
      const float t = static_cast<float>(frame) / 60;
      const float x = kind == Kind::Plane ? 0 : 0.25f, y = kind == Kind::Plane ? -0.1f : 0.05f;
      return Collider(kind, {x + 0.03f * std::sin(3 * t), y + 0.06f * std::sin(5 * t), 0});
    };
    Collider before = at(0);
    float worst = 0, lowest = 1;
    for (int frame = 1; frame <= 150; ++frame) {
      const float t = static_cast<float>(frame) / 60;
      const RigidTransform head{glm::angleAxis(std::sin(6 * t), glm::vec3(0, 1, 0)),
                                {0, 0.03f * std::sin(9 * t), 0}};
      const Collider now = at(frame);
      stepGuides(motionOf(head, before, now), settings, 1.0f / 60, workspace, guides);
      const GuideStats stats =
          measureGuides(guides, settings, now.capsules, nullptr, now.scenery());
      worst = std::max(worst, stats.penetrationMax);
      ASSERT_LT(stats.stretchMax, 1e-3f) << nameOf(kind);
      for (std::uint32_t g = 0; g < 96; ++g)
        lowest = std::min(lowest, heightOver(kind, now, guides.point(g, 12)));
      before = now;
    }
    EXPECT_LT(worst, 1e-3f) << nameOf(kind);
    EXPECT_LT(lowest, 5e-3f) << nameOf(kind) << ": nothing touches it";
  }
}

TEST(Colliders, ABarIsTheSameAsACapsuleAndAsAMesh) {
  const GuideSettings settings;
  std::vector<GuideStrands> hair;
  for (const Kind kind : {Kind::Capsule, Kind::Mesh}) {
    GuideStrands& guides = hair.emplace_back(lyingStrand(settings));
    GuideWorkspace workspace;
    Collider before(kind, {0, 0, 0});
    for (int frame = 1; frame <= 120; ++frame) {
      const Collider now(kind, {0, 0.0002f * static_cast<float>(frame), 0});
      stepGuides(motionOf({}, before, now), settings, 1.0f / 60, workspace, guides);
      before = now;
    }
  }
  for (std::uint32_t i = 0; i < 16; ++i)
    EXPECT_LT(glm::distance(hair[0].point(0, i), hair[1].point(0, i)), 0.1f * test::kBallCell);
}

TEST(Colliders, AScaledAndTurnedMeshIsTheMeshOfScaledAndTurnedPoints) {
  TriangleMesh mesh =
      surfaceNets([](glm::vec3 p) { return glm::length(p / glm::vec3(1, 0.6f, 0.8f)) - 0.05f; },
                  {glm::vec3(-0.07f), glm::vec3(0.07f)}, 4e-3f);
  const MeshSdf sdf(mesh, 2e-3f, 0.02f);
  const MeshCollider placed{&sdf, {glm::angleAxis(0.7f, glm::vec3(0.6f, 0, 0.8f)), {1, 2, -3}}, 2};
  for (glm::vec3& p : mesh.positions) p = placed.worldFromMesh.point(placed.scale * p);
  const MeshSdf moved(mesh, 4e-3f, 0.04f);
  const MeshCollider there{&moved, {}, 1};
  for (int x = -8; x <= 8; ++x)
    for (int y = -8; y <= 8; ++y)
      for (int z = -8; z <= 8; ++z) {
        const glm::vec3 p = placed.worldFromMesh.point(0.015f * glm::vec3(x, y, z));
        const glm::vec4 a = distanceAndGradient(placed, p), b = distanceAndGradient(there, p);
        if (std::abs(b.w) > 0.02f) continue;
        ASSERT_NEAR(a.w, b.w, 0.1f * 4e-3f);
        ASSERT_GT(glm::dot(glm::vec3(a), glm::vec3(b)), 0.98f);
      }
}

TEST(Colliders, HairOnAScaledMovingMeshMovesAsOnTheScaledMeshMoving) {
  // Twice the ball with twice the cells: the same field but for its unit.
  const auto small = ballSdf(0.5f * kRadius);
  TriangleMesh mesh = test::ballMesh(0.5f * kRadius);
  for (glm::vec3& p : mesh.positions) p *= 2;
  const MeshSdf large(mesh, 2 * test::kBallCell, 0.08f);
  std::vector<GuideStrands> hair;
  for (const MeshCollider& shape : {MeshCollider{small.get(), {}, 2}, {&large, {}, 1}}) {
    GuideStrands& guides = hair.emplace_back(lyingStrand({}));
    GuideWorkspace workspace;
    MeshCollider before = shape, now = shape;
    before.worldFromMesh.translation = {0, -kRadius, 0};
    for (int frame = 1; frame <= 60; ++frame) {
      const float t = static_cast<float>(frame) / 60;
      now.worldFromMesh = {glm::angleAxis(t, glm::vec3(0, 1, 0)), {0, 0.03f * t - kRadius, 0}};
      GuideMotion motion;
      motion.scenery.meshes = {&now, 1}, motion.sceneryBefore.meshes = {&before, 1};
      stepGuides(motion, {}, 1.0f / 60, workspace, guides);
      before = now;
    }
  }
  EXPECT_GT(std::abs(hair[0].point(0, 15).z), 0.01f) << "the ball's turn does not carry it";
  for (std::uint32_t i = 0; i < 16; ++i)
    EXPECT_LT(glm::distance(hair[0].point(0, i), hair[1].point(0, i)), 1e-4f);
}

TEST(Colliders, ATurningPlaneLiftsWhatLiesOnIt) {
  // Seen from the hair: the plane tips about its own point, far from it, and lifts the hair.
  const GuideSettings settings;
  GuideStrands guides = lyingStrand(settings);
  GuideWorkspace workspace;
  Plane before{{-1, 0, 0}, {0, 1, 0}};
  for (int frame = 1; frame <= 60; ++frame) {
    const float angle = 0.02f * static_cast<float>(frame) / 60;
    const Plane now{{-1, 0, 0}, {-std::sin(angle), std::cos(angle), 0}};
    GuideMotion motion;
    motion.worldFromHead.translation.y = 0.02f * static_cast<float>(frame) / 60;
    motion.scenery.planes = {&now, 1}, motion.sceneryBefore.planes = {&before, 1};
    stepGuides(motion, settings, 1.0f / 60, workspace, guides);
    ASSERT_LT(measureGuides(guides, settings, {}, nullptr, motion.scenery).penetrationMax, 1e-3f);
    before = now;
  }
  EXPECT_GT(guides.point(0, 15).y, 0.02f);
}

TEST(Colliders, WhatGrowsInsideOfHairPushesItOutGently) {
  const GuideSettings settings;
  for (const Kind kind : {Kind::Capsule, Kind::Mesh}) {
    GuideStrands guides(test::sphereGroom(64, 16), settings);
    GuideWorkspace workspace;
    const auto at = [&](int frame) {
      const float size = 0.02f + 0.98f * static_cast<float>(std::min(frame, 60)) / 60;
      return Collider(kind, {0.25f, size * kRadius, 0}, size);
    };
    Collider before = at(0);
    float fastest = 0, worst = 0;
    for (int frame = 1; frame <= 120; ++frame) {
      const Collider now = at(frame);
      stepGuides(motionOf({}, before, now), settings, 1.0f / 60, workspace, guides);
      const GuideStats stats =
          measureGuides(guides, settings, now.capsules, nullptr, now.scenery());
      fastest = std::max(fastest, stats.speedMax);
      worst = std::max(worst, stats.penetrationMax);
      before = now;
    }
    EXPECT_LT(fastest, 3.0f) << nameOf(kind);
    EXPECT_LT(worst, 1e-3f) << nameOf(kind);
  }
}

TEST(Colliders, WhatIsFarAwayChangesNoBit) {
  const GuideSettings settings;
  std::vector<std::uint64_t> hashes;
  for (const bool scenery : {false, true}) {
    GuideStrands guides(test::sphereGroom(33, 12), settings);
    GuideWorkspace workspace;
    Collider far(Kind::Plane, {0, -2, 0});
    far.meshes = Collider(Kind::Mesh, {0, 2, 0}).meshes;
    const Capsule head{{0, 0, 0}, {0, 0, 0}, 0.1f};
    for (int frame = 0; frame < 30; ++frame) {
      GuideMotion motion{{}, {&head, 1}, {&head, 1}};
      motion.wind.velocity = {2, 0, 0};
      if (scenery) motion.scenery = far.scenery();
      stepGuides(motion, settings, 1.0f / 60, workspace, guides);
    }
    StateHash hash;
    guides.addTo(hash);
    hashes.push_back(hash.value());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Colliders, GiveTheSameBitsOnEveryInstructionSetForAnyThreadCount) {
  std::vector<std::uint64_t> hashes;
  for (const std::string_view name : instructionSets())
    for (const int threads : {1, 3}) {
      const InstructionSetLimit set(name);
      const ThreadLimit limit(threads);
      GuideStrands guides(test::sphereGroom(50, 12), {});
      GuideWorkspace workspace;
      Collider both(Kind::Plane, {0, -0.15f, 0});
      both.planes[0].normal = glm::normalize(glm::vec3(0.2f, 1, 0.1f));
      both.meshes = Collider(Kind::Mesh, {0.2f, 0.1f, 0}, 1.1f).meshes;
      for (int frame = 0; frame < 20; ++frame)
        stepGuides(motionOf({}, both, both), {}, 1.0f / 60, workspace, guides);
      StateHash hash;
      guides.addTo(hash);
      hashes.push_back(hash.value());
    }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(Colliders, BadOnesAreRefusedByName) {
  const auto message = [](const Scenery& now, const Scenery& before = {}) {
    GuideStrands guides(test::oneStrand({0, -1, 0}, 0.1f, 4), {});
    GuideWorkspace workspace;
    GuideMotion motion;
    motion.scenery = now, motion.sceneryBefore = before;
    try {
      stepGuides(motion, {}, 1.0f / 60, workspace, guides);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  const auto plane = [&](Plane p) { return message({{&p, 1}, {}}); };
  EXPECT_EQ(plane({}), "accepted");
  EXPECT_NE(plane({{0, 0, 0}, {0, 2, 0}}).find("normal"), std::string::npos);
  EXPECT_NE(plane({{0, 0, 0}, {0, NAN, 0}}).find("normal"), std::string::npos);
  EXPECT_NE(plane({{0, INFINITY, 0}, {0, 1, 0}}).find("point"), std::string::npos);
  const auto sdf = ballSdf(kRadius);
  const auto mesh = [&](MeshCollider m) { return message({{}, {&m, 1}}); };
  EXPECT_EQ(mesh({sdf.get()}), "accepted");
  EXPECT_NE(mesh({}).find("distance field"), std::string::npos);
  EXPECT_NE(mesh({sdf.get(), {}, 0}).find("scale"), std::string::npos);
  EXPECT_NE(mesh({sdf.get(), {}, NAN}).find("scale"), std::string::npos);
  EXPECT_NE(mesh({sdf.get(), {{2, 0, 0, 0}, {}}}).find("rotation"), std::string::npos);
  EXPECT_NE(mesh({sdf.get(), {{1, 0, 0, 0}, {NAN, 0, 0}}}).find("translation"), std::string::npos);
  const std::vector<Plane> many(kMaxPlanes + 1), two(2), one(1);
  EXPECT_NE(message({many, {}}).find("at most"), std::string::npos);
  EXPECT_NE(message({two, {}}, {one, {}}).find("planes before"), std::string::npos);
}

}  // namespace
}  // namespace hair

// Planes and meshes around hair, frame after frame.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;
using test::stateOf;

// A standing dancer with long hair above a floor, and something beside the head.
struct Furnished {
  Scene scene;
  MeshSdf ball{builtinHead().mesh, 0.006f, 0.03f};
  std::vector<Plane> planes;
  std::vector<MeshCollider> meshes;

  explicit Furnished(FrameSettings settings = Scene::simulationOnly())
      : scene(small(Style::Long), Motion::still(), settings) {
    const glm::vec3 head = scene.pose.worldFromHead.translation;
    float lowest = 0;
    for (const glm::vec3 tip : test::tipsOf(scene.hair)) lowest = std::min(lowest, tip.y - head.y);
    planes = {{head + glm::vec3(0, lowest - 0.02f, 0), {0, 1, 0}}};
    meshes = {{&ball, {glm::quat(1, 0, 0, 0), head + glm::vec3(0.25f, -0.2f, 0)}, 0.4f}};
  }
  BodyState body() {
    BodyState body = scene.bodyAt(0);
    body.scenery = {planes, meshes};
    return body;
  }
  void step() { frame(body(), scene.settings, 1.0f / 60, scene.hair, scene.profile); }
  // Metres that a guide point or a drawn one is inside at most.
  float deepest(bool drawn) const {
    float worst = 0;
    const auto look = [&](glm::vec3 p) {
      for (const Plane& plane : planes) worst = std::max(worst, -distanceAndGradient(plane, p).w);
      for (const MeshCollider& mesh : meshes)
        worst = std::max(worst, -distanceAndGradient(mesh, p).w);
    };
    const Hair& hair = scene.hair;
    if (drawn)
      for (std::size_t s = 0; s < hair.strands().strandCount(); ++s)
        for (std::uint32_t p = hair.strands().first[s] + 1; p < hair.strands().first[s + 1]; ++p)
          look(hair.strands().points[p]);
    else
      for (std::size_t g = 0; g < hair.guides.guideCount(); ++g)
        for (std::uint32_t i = 1; i < hair.guides.pointsPerGuide(); ++i)
          look(hair.guides.point(g, i));
    return worst;
  }
  float fastest() const {
    float speed = 0;
    for (const LaneVec3& v : scene.hair.guides.velocity)
      for (std::size_t l = 0; l < kLanes; ++l) speed = std::max(speed, glm::length(lane(v, l)));
    return speed;
  }
};

TEST(FrameScenery, WhatMovesIntoHairPushesItAside) {
  Furnished furnished;
  furnished.step();
  for (int f = 0; f < 60; ++f) {
    furnished.planes[0].point.y += 0.002f;
    furnished.meshes[0].worldFromMesh.translation.x -= 0.002f;
    furnished.step();
    ASSERT_LE(furnished.deepest(false), 1e-3f) << f;
    ASSERT_LE(furnished.deepest(true), 1e-3f) << f;
  }
  Furnished without;
  without.planes.clear(), without.meshes.clear();
  without.step();
  without.planes = furnished.planes, without.meshes = furnished.meshes;
  EXPECT_GT(without.deepest(false), 0.02f) << "nothing is in the way";
}

TEST(FrameScenery, WhatAppearsInHairDoesNotThrowIt) {
  Furnished furnished;
  const std::vector<Plane> planes = std::move(furnished.planes);
  furnished.planes.clear();
  furnished.step();
  furnished.planes = planes;
  furnished.planes[0].point.y += 0.1f;
  ASSERT_GT(furnished.deepest(false), 0.02f);
  furnished.step();
  EXPECT_LE(furnished.deepest(false), 1e-3f);
  EXPECT_LT(furnished.fastest(), 3);
}

TEST(FrameScenery, ARestartRaisesItSlowly) {
  Furnished furnished;
  furnished.planes[0].point.y += 0.1f;
  restart(furnished.body(), furnished.scene.settings, 1, furnished.scene.hair);
  EXPECT_LE(furnished.deepest(false), 1e-3f);
  furnished.step();
  EXPECT_LT(furnished.fastest(), 1);
}

TEST(FrameScenery, ASavedRunGoesOnWithTheSameBits) {
  FrameSettings settings = Scene::simulationOnly();
  settings.wind.velocity = {0, 0, 5};
  settings.wind.occlusion = 0.5f;
  Furnished run(settings), other(settings);
  const auto on = [](Furnished& furnished) {
    furnished.planes[0].point.y += 0.003f;
    furnished.meshes[0].worldFromMesh.translation.x -= 0.002f;
    furnished.step();
  };
  for (int f = 0; f < 20; ++f) on(run);
  ASSERT_FALSE(run.scene.hair.repulsion.windShare.empty());
  other.step();
  std::istringstream in(stateOf(run.scene.hair));
  restoreState(in, other.scene.hair);
  other.planes = run.planes;
  other.meshes[0].worldFromMesh = run.meshes[0].worldFromMesh;
  for (int f = 0; f < 20; ++f) on(run), on(other);
  EXPECT_TRUE(stateOf(other.scene.hair) == stateOf(run.scene.hair));
}

TEST(FrameScenery, WindOcclusionNeedsTheDensityOfSelfCollision) {
  const auto after = [](bool selfCollision, float occlusion) {
    FrameSettings settings = Scene::simulationOnly();
    settings.selfCollision = selfCollision;
    settings.repulsion.strandStride = 1;
    settings.wind.velocity = {0, 0, 5};
    settings.wind.occlusion = occlusion;
    Scene scene(small(Style::Smooth), Motion::still(), settings);
    for (int f = 0; f < 10; ++f) scene.step();
    return scene.hash();
  };
  EXPECT_EQ(after(false, 0), after(false, 1));
  EXPECT_NE(after(true, 0), after(true, 1));
}

}  // namespace
}  // namespace hair

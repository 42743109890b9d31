// Drawn strands among obstacles of every kind.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/wisps/literal.h>
#include <libhair/wisps/wisps.h>
#include <tests/guides/ball.h>

namespace hair {
namespace {

// Two guides that pass a place on either side; what is drawn between them goes through it.
struct Passing {
  Groom groom;
  GuideStrands guides;
  Wisps wisps;
  const MeshSdf* headAtRest;

  explicit Passing(const RigidTransform& head = {}, const MeshSdf* atRest = nullptr)
      : groom(made()),
        guides(groom, {}, head),
        wisps(groom, guides, {}, atRest),
        headAtRest(atRest) {}

  static Groom made() {
    Groom groom;
    groom.pointsPerGuide = 12;
    for (const float side : {-1.0f, 1.0f})
      for (int i = 0; i < 12; ++i) {
        const float t = static_cast<float>(i) / 11;
        groom.guidePoints.emplace_back(side * (0.02f + 0.09f * std::sin(3.14159265f * t)),
                                       0.3f - 0.6f * t, 0);
      }
    for (int s = 0; s <= 20; ++s) {
      const float w = static_cast<float>(s) / 20;
      groom.parents.emplace_back(w < 0.5f ? 0 : 1, w < 0.5f ? 1 : 0, 0);
      groom.weights.emplace_back(std::max(w, 1 - w), std::min(w, 1 - w), 0);
      // 41 points: a block and a lone tip beside whole blocks.
      groom.first.push_back(groom.first.back() + 41);
    }
    return groom;
  }
  template <class Distance>
  float deepest(Distance distance) const {
    float d = 1;
    for (std::size_t s = 0; s < groom.strandCount(); ++s)
      for (std::size_t k = groom.first[s] + 1; k < groom.first[s + 1]; ++k)
        d = std::min(d, distance(wisps.points[k]));
    return d;
  }
  // Draws the strands, and compares them with the plain formula.
  void draw(const ColliderState& colliders) {
    interpolateWisps(guides, colliders, wisps);
    const auto expected =
        literal::interpolateWisps(groom, guides, colliders, wisps.settings, headAtRest);
    for (std::size_t p = 0; p < expected.size(); ++p)
      ASSERT_LT(glm::distance(glm::dvec3(wisps.points[p]), expected[p]), 5e-6) << "point " << p;
  }
};

const RigidTransform kHead{glm::angleAxis(0.8f, glm::vec3(0, 0.6f, 0.8f)), {1, 2, -3}};

TEST(Wisps, NoDrawnPointIsLeftInsideACapsule) {
  Passing hair;
  const Capsule ball{{0, 0, 0}, {0, 0, 0}, 0.08f};
  const auto distance = [&](glm::vec3 p) { return distanceAndGradient(ball, p).w; };
  EXPECT_LT(hair.deepest(distance), -0.05f) << "nothing to avoid";
  hair.draw({{}, {}, {&ball, 1}, {&ball, 1}, nullptr});
  EXPECT_GE(hair.deepest(distance), hair.wisps.settings.clearance - 1e-6f);
}

TEST(Wisps, NoDrawnPointIsLeftInsideTheHeadsField) {
  Passing hair(kHead);
  const auto sdf = test::ballSdf(0.08f);
  const auto distance = [](glm::vec3 p) { return glm::distance(p, kHead.translation) - 0.08f; };
  EXPECT_LT(hair.deepest(distance), -0.05f) << "nothing to avoid";
  hair.draw({kHead, kHead, {}, {}, sdf.get()});
  // The clearance is more than the grid's error.
  EXPECT_GE(hair.deepest(distance), 0);
}

TEST(Wisps, AStrandThatRestsInTheHeadMayStayAsDeep) {
  const auto sdf = test::ballSdf(0.08f);
  Passing hair({}, sdf.get());
  const auto atRest = hair.wisps.points;
  hair.draw({{}, {}, {}, {}, sdf.get()});
  EXPECT_EQ(hair.wisps.points, atRest);
  // A head that comes nearer pushes them back to that depth.
  const RigidTransform moved{glm::quat(1, 0, 0, 0), {0.02f, 0, 0.01f}};
  hair.draw({moved, {}, {}, {}, sdf.get()});
  EXPECT_NE(hair.wisps.points, atRest);
}

TEST(Wisps, NoDrawnPointIsLeftInsideAPlacedMesh) {
  Passing hair(kHead);
  const auto sdf = test::ballSdf(0.1f);
  const MeshCollider ball{
      sdf.get(), {glm::angleAxis(-2.0f, glm::vec3(1, 0, 0)), kHead.translation}, 0.8f};
  const auto distance = [](glm::vec3 p) { return glm::distance(p, kHead.translation) - 0.08f; };
  EXPECT_LT(hair.deepest(distance), -0.05f) << "nothing to avoid";
  ColliderState colliders{kHead, kHead, {}, {}};
  colliders.scenery.meshes = {&ball, 1};
  hair.draw(colliders);
  EXPECT_GE(hair.deepest(distance), 0);
}

TEST(Wisps, NoDrawnPointIsLeftBehindAPlane) {
  Passing hair;
  const glm::vec3 normal = glm::normalize(glm::vec3(1, 1, 1));
  const Plane wall{{0, -0.2f, 0}, normal};
  const auto distance = [&](glm::vec3 p) { return distanceAndGradient(wall, p).w; };
  EXPECT_LT(hair.deepest(distance), -0.05f) << "nothing to avoid";
  ColliderState colliders;
  colliders.scenery.planes = {&wall, 1};
  hair.draw(colliders);
  EXPECT_GE(hair.deepest(distance), hair.wisps.settings.clearance - 1e-6f);
}

TEST(Wisps, SceneryThatNoStrandMeetsChangesNoBit) {
  Passing hair;
  const auto free = hair.wisps.points;
  const auto sdf = test::ballSdf(0.1f);
  const MeshCollider ball = test::meshAt(*sdf, {0.5f, 0, 0});
  const Plane floor{{0, -0.4f, 0}};
  ColliderState colliders;
  colliders.scenery = {{&floor, 1}, {&ball, 1}};
  interpolateWisps(hair.guides, colliders, hair.wisps);
  EXPECT_EQ(hair.wisps.points, free);
}

TEST(Wisps, BadSceneryIsRefused) {
  Passing hair;
  const MeshCollider none;
  ColliderState colliders;
  colliders.scenery.meshes = {&none, 1};
  EXPECT_THROW(interpolateWisps(hair.guides, colliders, hair.wisps), Error);
}

}  // namespace
}  // namespace hair

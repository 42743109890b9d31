// What can be drawn of a hair's inside is where it says.

#include <cmath>

#include <gtest/gtest.h>

#include <libhair/density/grid_cells.h>
#include <libhair/simulation/insides.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;

std::vector<LineVertex> linesOf(Inside what, const Scene& scene) {
  std::vector<LineVertex> lines;
  addLines(what, scene.hair, scene.settings.guides, lines);
  EXPECT_EQ(lines.size() % 2, 0u);
  return lines;
}

struct Insides : testing::Test {
  Scene scene{small(Style::Smooth), Motion::dance(), {}};
  void SetUp() override {
    scene.simulation.restart(scene.bodyAt(0), 1);
    for (int f = 0; f < 60; ++f) scene.step();
  }
};

TEST_F(Insides, GuidesAndTensionAreTheLinks) {
  const std::size_t links = scene.hair.guides.guideCount() * scene.hair.guides.linksPerGuide();
  for (const Inside what : {Inside::Guides, Inside::Tension}) {
    const auto lines = linesOf(what, scene);
    ASSERT_EQ(lines.size(), 2 * links);
    EXPECT_EQ(lines[0].position, scene.hair.guides.point(0, 0));
    EXPECT_EQ(lines[1].position, scene.hair.guides.point(0, 1));
  }
}

TEST_F(Insides, FramesAreOrthonormal) {
  const auto lines = linesOf(Inside::GuideFrames, scene);
  ASSERT_EQ(lines.size(), 6 * scene.hair.guides.guideCount() * scene.hair.guides.pointsPerGuide());
  for (std::size_t i = 0; i < lines.size(); i += 6) {
    glm::mat3 axes;
    for (int c = 0; c < 3; ++c)
      axes[c] = (lines[i + 2 * c + 1].position - lines[i + 2 * c].position) / 5e-3f;
    EXPECT_NEAR(glm::determinant(axes), 1, 1e-2);
  }
}

TEST_F(Insides, ContactsAreOnColliders) {
  const auto lines = linesOf(Inside::Contacts, scene);
  ASSERT_GT(lines.size(), 0u) << "hair on a head and shoulders touches them";
  const RigidTransform headFromWorld = inverse(scene.hair.worldFromHead);
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    const glm::vec3 p = lines[i].position;
    float nearest = scene.hair.head->distance(headFromWorld.point(p));
    for (const Capsule& c : scene.hair.capsules)
      nearest = std::min(nearest, distanceAndGradient(c, p).w);
    EXPECT_LT(nearest, scene.settings.guides.skin + 1e-3f);
    EXPECT_NEAR(glm::distance(p, lines[i + 1].position), 0.01f, 1e-3f);
  }
}

TEST_F(Insides, ContoursOfTheHeadAreWhereItsDistanceIsZero) {
  const Plane floor{{0, 0, 0}, {0, 1, 0}};
  scene.hair.planes = {floor};
  const auto lines = linesOf(Inside::Colliders, scene);
  const RigidTransform headFromWorld = inverse(scene.hair.worldFromHead);
  std::size_t onHead = 0, onFloor = 0;
  for (const LineVertex& end : lines) {
    // Contours are straight between points of a grid of a fortieth of the head.
    onHead += std::abs(scene.hair.head->distance(headFromWorld.point(end.position))) < 1e-3f;
    onFloor += std::abs(end.position.y) < 1e-5f;
  }
  EXPECT_GT(onHead, 1000u);
  EXPECT_GE(onFloor, 36u);
}

TEST_F(Insides, BricksHoldTheHair) {
  const DensityGrid& grid = scene.hair.maps.front().grid;
  const auto lines = linesOf(Inside::Bricks, scene);
  ASSERT_EQ(lines.size(), 24 * grid.brickCount());
  std::vector<Bounds> boxes(grid.brickCount());
  for (std::size_t i = 0; i < lines.size(); ++i)
    boxes[i / 24].extend(grid.cells->frame.cellCoordinates(lines[i].position));
  for (const glm::vec3 p : scene.hair.wisps.points) {
    const glm::vec3 u = grid.cells->frame.cellCoordinates(p);
    ASSERT_TRUE(std::ranges::any_of(boxes, [&](const Bounds& b) {
      return glm::all(glm::greaterThan(u, b.lower - 1e-2f)) &&
             glm::all(glm::lessThan(u, b.upper + 1e-2f));
    }));
  }
}

TEST_F(Insides, PushIsAsLongAsItIsStrong) {
  const GuideStrands& guides = scene.hair.guides;
  const std::size_t n = guides.pointsPerGuide();
  scene.hair.repulsion.push.assign(guides.position.size(), LaneVec3{});
  EXPECT_TRUE(linesOf(Inside::Push, scene).empty());
  setLane(scene.hair.repulsion.push[n + 3], 2, {0, 7, 0});  // of guide 18, point 3
  const auto lines = linesOf(Inside::Push, scene);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].position, guides.point(kLanes + 2, 3));
  EXPECT_NEAR(glm::distance(lines[1].position, lines[0].position + glm::vec3(0, 7e-3f, 0)), 0,
              1e-6f);
}

TEST_F(Insides, FramesGoWithHairThatIsTakenElsewhere) {
  scene.simulation.moveOrigin({1, 2, 3});
  EXPECT_EQ(linesOf(Inside::GuideFrames, scene)[0].position, scene.hair.guides.point(0, 0));
}

TEST(InsideNames, AreAllDifferent) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < kInsideCount; ++i)
    names.push_back(insideName(static_cast<Inside>(i)));
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_THROW(insideName(static_cast<Inside>(kInsideCount)), Error);
}

}  // namespace
}  // namespace hair

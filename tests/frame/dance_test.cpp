// Hair on heads that move.

#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/wisps/guide_curves.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;

TEST(Dance, SameBitsForAnyThreadCount) {
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    Scene scene(small(Style::Smooth), Motion::dance());
    ASSERT_TRUE(scene.settings.selfCollision);
    for (int f = 0; f < 60; ++f) scene.step();
    hashes.push_back(scene.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Dance, ShadowsAndColoursHaveTheSameBitsForAnyThreadCount) {
  std::vector<std::vector<std::uint32_t>> colours;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    Scene scene(small(Style::Curly), Motion::dance(), {});
    for (int f = 0; f < 20; ++f) scene.step();
    colours.push_back(scene.hair.colours);
  }
  EXPECT_EQ(colours[0], colours[1]);
  EXPECT_EQ(colours[0], colours[2]);
}

TEST(Dance, WhatIsOffCostsNothing) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.settings.selfCollision = false;
  scene.step();
  EXPECT_TRUE(scene.hair.transmittance.empty());
  EXPECT_TRUE(scene.hair.colours.empty());
  EXPECT_TRUE(scene.hair.maps.empty());
  for (Stage stage :
       {Stage::Deposit, Stage::Transmittance, Stage::Filter, Stage::Shade, Stage::SelfCollision})
    EXPECT_EQ(scene.profile[static_cast<std::size_t>(stage)].nanoseconds, 0);
}

// Guides of a wisp on the crown may fall to either side of the head; where the head is in the way,
// a strand is drawn beside one of them, and must not keep what the middle between all was away from
// it.
TEST(Dance, StrandsStayWithTheirMainGuideWhereTheHeadIsInTheWay) {
  const auto farthest = [](const Hair& hair) {
    float distance = 0;
    for (std::size_t s = 0; s < hair.groom->strandCount(); ++s) {
      const auto points = hair.strands().strand(s);
      const auto n = static_cast<std::uint32_t>(points.size());
      for (std::uint32_t k = 0; k < n; ++k)
        distance =
            std::max(distance,
                     glm::distance(points[k], hair.wisps.curves->point(hair.groom->parents[s].x,
                                                                       hair.wisps.sampleOf(k, n))));
    }
    return distance;
  };
  for (const Style style : {Style::Smooth, Style::Curly, Style::Long}) {
    Scene scene(styleSettings(style), Motion::dance());
    const float groomed = farthest(scene.hair);
    for (int f = 0; f < 10; ++f) scene.step();
    EXPECT_LT(farthest(scene.hair), groomed + 0.015f) << static_cast<int>(style);
  }
}

TEST(Dance, ALampThatMovesDoesNotMoveTheHair) {
  std::vector<std::uint64_t> hashes;
  for (const glm::vec3 light : {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)}) {
    FrameSettings settings;
    settings.lights = {Light::parallel(light)};
    Scene scene(small(Style::Smooth), Motion::dance(), settings);
    for (int f = 0; f < 60; ++f) scene.step();
    hashes.push_back(scene.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace hair

// Hair on heads that move.

#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>

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

// Hair on heads that move.

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/files/bvh_file.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;

TEST(Dance, SameBitsAfter600FramesForAnyThreadCount) {
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    Scene scene(small(Style::Smooth), Motion::dance());
    ASSERT_TRUE(scene.settings.selfCollision);
    for (int f = 0; f < 600; ++f) scene.step();
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
  EXPECT_EQ(scene.hair.map.counts.data(), nullptr);
  for (Stage stage :
       {Stage::Deposit, Stage::Transmittance, Stage::Filter, Stage::Shade, Stage::SelfCollision})
    EXPECT_EQ(scene.profile[static_cast<std::size_t>(stage)].nanoseconds, 0);
}

TEST(Dance, ALampThatMovesDoesNotMoveTheHair) {
  std::vector<std::uint64_t> hashes;
  for (const glm::vec3 light : {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)}) {
    FrameSettings settings;
    settings.light.direction = light;
    Scene scene(small(Style::Smooth), Motion::dance(), settings);
    for (int f = 0; f < 60; ++f) scene.step();
    hashes.push_back(scene.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Dance, SelfCollisionKeepsHairFromBeingDenser) {
  // The densest twentieth of the guide points, relative to what the groom allows, over a spin.
  const auto excess = [](bool selfCollision) {
    FrameSettings settings = Scene::simulationOnly();
    Scene scene(styleSettings(Style::Smooth), Motion::dance(), settings);
    Repulsion probe;
    allowRestDensity(scene.hair.strands(), scene.groom.fibre, scene.hair.guides, settings.repulsion,
                     probe);
    scene.settings.selfCollision = selfCollision;
    double sum = 0;
    for (int f = 0; f < 240; ++f) {
      scene.step();
      if (f % 10 != 0) continue;
      measureDensity(scene.hair.strands(), scene.groom.fibre, settings.repulsion, probe.density);
      for (std::size_t at = 0; at < probe.allowed.size(); ++at)
        for (std::size_t l = 0; l < kLanes; ++l) {
          const float d =
              sampleDensity(probe.density, lane(scene.hair.guides.position[at], l)).density;
          sum += std::max(0.0f, d / probe.allowed[at][l] - 1);
        }
    }
    return sum;
  };
  EXPECT_LT(excess(true), 0.9 * excess(false));
}

struct Promise {
  const char* clip;
  float stretch;
};

class RealDance : public testing::TestWithParam<Promise> {};

TEST_P(RealDance, LengthsHoldAndCollidersStayOut) {
  const auto file = std::filesystem::path(HAIR_DATA_DIR) / "motion" / GetParam().clip;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  Scene scene(styleSettings(Style::Smooth), Motion(clipFromBvh(readBvh(file))));
  restart(scene.bodyAt(0), scene.settings, 1, scene.hair);
  GuideStats worst;
  while (scene.time + 1.0 / 60 < scene.motion.duration()) {
    scene.step();
    const GuideStats s = scene.stats();
    worst.stretchMax = std::max(worst.stretchMax, s.stretchMax);
    worst.penetrationMax = std::max(worst.penetrationMax, s.penetrationMax);
    ASSERT_TRUE(std::isfinite(s.kineticEnergy)) << "at " << scene.time << " s";
  }
  EXPECT_LE(worst.stretchMax, GetParam().stretch);
  EXPECT_LE(worst.penetrationMax, 1e-3f);
}

INSTANTIATE_TEST_SUITE_P(Clips, RealDance,
                         testing::Values(Promise{"05_11.bvh", 1e-3f}, Promise{"05_06.bvh", 1e-2f}),
                         [](const auto& test) {
                           return "Clip" + std::string(test.param.clip).substr(0, 5);
                         });

}  // namespace
}  // namespace hair

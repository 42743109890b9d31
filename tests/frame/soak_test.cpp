// Whole styles over many frames: at rest, and on real dances.

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/files/bvh_file.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;

class AtRest : public testing::TestWithParam<Style> {};

TEST_P(AtRest, AGroomStaysWhereItWasGroomed) {
  // Ten seconds, self-collision on, the body standing under it. No warm-up: gravity acts from the
  // first frame on, on the groom as it came.
  Scene scene(styleSettings(GetParam()), Motion::still());
  ASSERT_TRUE(scene.settings.selfCollision);
  double energyAt5 = 0;
  for (int f = 0; f < 600; ++f) {
    scene.step();
    if (f == 300) energyAt5 = scene.stats().kineticEnergy;
  }
  const Groom& groom = scene.groom;
  double moved = 0;
  for (std::size_t g = 0; g < groom.guideCount(); ++g) {
    const glm::vec3 tip = scene.pose.worldFromHead.point(groom.guide(g).back());
    moved += glm::distance(tip, scene.hair.guides.point(g, groom.pointsPerGuide - 1));
  }
  moved /= static_cast<double>(groom.guideCount());
  const GuideStats stats = scene.stats();
  RecordProperty("mean_tip_movement_m", std::to_string(moved));
  EXPECT_LT(moved, 2e-3);
  // A hundredth of a microjoule for all guides together, 0.8 grams: 5 mm/s.
  EXPECT_LT(energyAt5, 1e-8);
  EXPECT_LT(stats.kineticEnergy, 1e-8);
  EXPECT_LT(stats.penetrationMax, 1e-3f);
}

INSTANTIATE_TEST_SUITE_P(Styles, AtRest, testing::Values(Style::Smooth, Style::Curly, Style::Long),
                         [](const auto& test) {
                           return std::string(test.param == Style::Smooth  ? "Smooth"
                                              : test.param == Style::Curly ? "Curly"
                                                                           : "Long");
                         });

TEST(Dance, SameBitsAfter600FramesForAnyThreadCount) {
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    Scene scene(test::small(Style::Smooth), Motion::dance());
    ASSERT_TRUE(scene.settings.selfCollision);
    for (int f = 0; f < 600; ++f) scene.step();
    hashes.push_back(scene.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
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

// A groom on a head that does not move.

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace hair

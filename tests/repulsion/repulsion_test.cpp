#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/random.h>
#include <libhair/repulsion/literal.h>
#include <libhair/repulsion/repulsion.h>

namespace hair {
namespace {

// Upright guides about the origin, closest together in the middle; drawn hair is the guides.
struct Bundle {
  Groom groom;
  StrandSet drawn;

  explicit Bundle(float spread) {
    groom.pointsPerGuide = 9;
    groom.fibre.hairsPerStrand = 100;
    for (std::uint32_t g = 0; g < 400; ++g) {
      const float a = 6.2831853f * uniform(g, 0), r = spread * uniform(g, 1);
      std::vector<glm::vec3> points;
      for (int i = 0; i < 9; ++i)
        points.emplace_back(r * std::cos(a), 0.02f * static_cast<float>(i), r * std::sin(a));
      groom.guidePoints.insert(groom.guidePoints.end(), points.begin(), points.end());
      drawn.append(points);
    }
  }
};

RepulsionSettings everyStrand(RepulsionKind kind) {
  RepulsionSettings settings;
  settings.kind = kind;
  settings.strandStride = 1;
  settings.threshold = 0;
  return settings;
}

class Repels : public testing::TestWithParam<RepulsionKind> {};

TEST_P(Repels, NothingInAGroomAtRest) {
  const Bundle bundle(0.05f);
  const GuideStrands guides(bundle.groom, {});
  const RepulsionSettings settings = everyStrand(GetParam());
  Repulsion repulsion;
  allowRestDensity(bundle.drawn, bundle.groom.fibre, guides, settings, repulsion);
  repel(guides, settings, repulsion);
  for (const LaneVec3& push : repulsion.push)
    for (std::size_t l = 0; l < kLanes; ++l) ASSERT_EQ(lane(push, l), glm::vec3(0));
}

TEST_P(Repels, OutwardsWhatHasBeenPressedTogether) {
  const Bundle loose(0.06f), tight(0.03f);
  const GuideStrands guides(loose.groom, {}), pressed(tight.groom, {});
  RepulsionSettings settings = everyStrand(GetParam());
  Repulsion repulsion;
  allowRestDensity(loose.drawn, loose.groom.fibre, guides, settings, repulsion);
  measureDensity(tight.drawn, tight.groom.fibre, settings, repulsion.density);
  repel(pressed, settings, repulsion);
  double outwards = 0;
  float strongest = 0;
  for (std::size_t at = 0; at < repulsion.push.size(); ++at)
    for (std::size_t l = 0; l < kLanes; ++l) {
      const glm::vec3 p = lane(pressed.position[at], l), push = lane(repulsion.push[at], l);
      outwards += p.x * push.x + p.z * push.z;
      strongest = std::max(strongest, glm::length(push));
    }
  EXPECT_GT(outwards, 0);
  EXPECT_GT(strongest, 1);
  EXPECT_LE(strongest, settings.limit * 1.0001f);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Repels,
                         testing::Values(RepulsionKind::CellCentre, RepulsionKind::Gradient),
                         [](const auto& test) {
                           return test.param == RepulsionKind::Gradient ? "Gradient" : "CellCentre";
                         });

TEST_P(Repels, AsTheGridsOwnLookUpsSay) {
  // Off the hair too, across the grid's seam, and in a grid that the hair does not fit into.
  const Bundle bundle(0.06f);
  GuideStrands guides(bundle.groom, {});
  RepulsionSettings settings = everyStrand(GetParam());
  settings.limit = 1e9f;
  for (const int cells : {4, 64})
    for (const float away : {0.0f, 37.3f}) {
      settings.cells = cells;
      StrandSet drawn = bundle.drawn;
      for (glm::vec3& p : drawn.points) p.x -= away;
      for (std::size_t at = 0; at < guides.position.size(); ++at)
        for (std::uint32_t l = 0; l < kLanes; ++l) {
          const auto i = static_cast<std::uint32_t>(at * kLanes) + l;
          setLane(guides.position[at], l,
                  {0.3f * uniform(i, 3) - 0.15f - away, 0.4f * uniform(i, 4) - 0.1f,
                   0.3f * uniform(i, 5) - 0.15f});
        }
      Repulsion repulsion;
      allowRestDensity(drawn, bundle.groom.fibre, guides, settings, repulsion);
      for (Lanes& allowed : repulsion.allowed) allowed = lanes(1e4f);
      repel(guides, settings, repulsion);
      repel(guides, settings, repulsion);
      int pushed = 0;
      for (std::size_t at = 0; at < repulsion.push.size(); ++at)
        for (std::size_t l = 0; l < kLanes; ++l) {
          const glm::vec3 expected =
              literal::push(repulsion.density, settings, 1e4f, lane(guides.position[at], l));
          const glm::vec3 got = lane(repulsion.push[at], l);
          pushed += got != glm::vec3(0);
          ASSERT_LE(glm::distance(got, expected), 2e-6f * glm::length(expected)) << cells;
        }
      EXPECT_GT(pushed, 100);
    }
}

TEST_P(Repels, WithTheSameBitsOnEveryInstructionSet) {
  const Bundle loose(0.06f), tight(0.03f);
  const GuideStrands guides(loose.groom, {}), pressed(tight.groom, {});
  const RepulsionSettings settings = everyStrand(GetParam());
  std::vector<std::vector<LaneVec3>> pushes;
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    Repulsion repulsion;
    allowRestDensity(loose.drawn, loose.groom.fibre, guides, settings, repulsion);
    measureDensity(tight.drawn, tight.groom.fibre, settings, repulsion.density);
    repel(pressed, settings, repulsion);
    pushes.push_back(repulsion.push);
    EXPECT_EQ(std::memcmp(pushes[0].data(), repulsion.push.data(),
                          repulsion.push.size() * sizeof(LaneVec3)),
              0)
        << name;
  }
}

TEST(Repulsion, DensityIsTheLengthOfHairPerVolume) {
  const Bundle bundle(0.05f);
  RepulsionSettings settings = everyStrand(RepulsionKind::Gradient);
  DensityGrid density;
  measureDensity(bundle.drawn, bundle.groom.fibre, settings, density);
  double length = 0;
  for (int x = density.lower.x; x <= density.upper.x; ++x)
    for (int y = density.lower.y; y <= density.upper.y; ++y)
      for (int z = density.lower.z; z <= density.upper.z; ++z)
        length += static_cast<double>(density.density({x, y, z})) * std::pow(settings.cellSize, 3);
  EXPECT_NEAR(length, 400 * 0.16 * 100, 400 * 0.16 * 100 * 0.01);
}

TEST(Repulsion, SettingsOutOfRangeAreRefused) {
  const Bundle bundle(0.05f);
  const GuideStrands guides(bundle.groom, {});
  Repulsion repulsion;
  RepulsionSettings settings;
  settings.tolerance = 0.5f;
  EXPECT_THROW(allowRestDensity(bundle.drawn, bundle.groom.fibre, guides, settings, repulsion),
               Error);
  settings = {};
  settings.strandStride = 0;
  EXPECT_THROW(allowRestDensity(bundle.drawn, bundle.groom.fibre, guides, settings, repulsion),
               Error);
}

}  // namespace
}  // namespace hair

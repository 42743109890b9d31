#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/repulsion/repulsion.h>

namespace hair {
namespace {

const glm::vec3 kEast(3, 0, 0);

// `side` by `side` strands that hang a centimetre apart, each for a hundred hairs: 1e6 metres of
// hair per m³. Drawn hair is the guides, off the walls of cells.
struct Block {
  Groom groom;
  StrandSet drawn;
  std::uint32_t side;
  RepulsionSettings settings;
  Repulsion repulsion;

  explicit Block(std::uint32_t side_) : side(side_) {
    groom.pointsPerGuide = 21;
    groom.fibre.hairsPerStrand = 100;
    settings.strandStride = 1;
    for (std::uint32_t s = 0; s < side * side; ++s) {
      std::vector<glm::vec3> points;
      for (int i = 0; i <= 20; ++i)
        points.push_back(glm::vec3(0.003f) + 0.01f * glm::vec3(s % side, -i, s / side));
      groom.guidePoints.insert(groom.guidePoints.end(), points.begin(), points.end());
      drawn.append(points);
    }
  }
  // How much of the wind reaches the middle of each strand.
  std::vector<float> shares(const Wind& wind) {
    const GuideStrands guides(groom, {});
    measureDensity(drawn, groom.fibre, settings, repulsion.density);
    occludeWind(guides, wind, repulsion);
    std::vector<float> result;
    for (std::size_t g = 0; g < guides.guideCount(); ++g)
      result.push_back(repulsion.windShare[g / kLanes * 21 + 10][g % kLanes]);
    return result;
  }
};

Wind wind(float occlusion, glm::vec3 velocity = kEast) {
  Wind wind;
  wind.velocity = velocity;
  wind.occlusion = occlusion;
  return wind;
}

TEST(WindOcclusion, ALoneStrandAcrossTheWindHasNone) {
  Block lone(1);
  for (const glm::vec3 velocity : {kEast, glm::vec3(0, 0, -2), glm::vec3(1, 0, 1.7f)})
    EXPECT_EQ(lone.shares(wind(1e-3f, velocity))[0], 1);
}

TEST(WindOcclusion, GrowsWithTheHairThatIsUpwind) {
  Block block(16);
  const std::vector<float> shares = block.shares(wind(1e-5f));
  const auto at = [&](std::uint32_t x) { return shares[8 * 16 + x]; };
  EXPECT_GT(at(0), 0.999f);
  EXPECT_LT(at(8), 0.75f);
  for (std::uint32_t x = 1; x < 16; ++x) EXPECT_LE(at(x), at(x - 1) + 1e-4f) << x;
  // From the other side it is the other way round.
  const std::vector<float> west = block.shares(wind(1e-5f, -kEast));
  EXPECT_GT(west[8 * 16 + 15], 0.999f);
  EXPECT_LT(west[8 * 16 + 7], 0.75f);
}

TEST(WindOcclusion, IsExpOfMinusTheHairUpwind) {
  // 8 cm of 1e6 metres per m³ at 1e-5 metres: a share of exp(-0.8) well inside of the block.
  Block block(24);
  EXPECT_NEAR(block.shares(wind(1e-5f))[12 * 24 + 16], std::exp(-0.8f), 0.05f);
}

TEST(WindOcclusion, TheInsideOfThickHairIsBlownLessThanItsOutside) {
  Block block(16);
  GuideStrands guides(block.groom, {});
  GuideWorkspace workspace;
  block.shares(wind(1e-4f));
  GuideMotion motion;
  motion.wind = wind(1e-4f);
  motion.windShare = block.repulsion.windShare;
  for (int frame = 0; frame < 30; ++frame) stepGuides(motion, {}, 1.0f / 60, workspace, guides);
  const auto blown = [&](std::size_t x) {
    const std::size_t g = 8 * 16 + x;
    return guides.point(g, 20).x - block.groom.guide(g)[20].x;
  };
  EXPECT_GT(blown(0), 0.01f);
  EXPECT_LT(blown(10), 0.3f * blown(0));
}

TEST(WindOcclusion, IsTheSameOnEveryInstructionSet) {
  std::vector<float> best;
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    Block block(12);
    const std::vector<float> shares = block.shares(wind(3e-5f, {1, 0.3f, 0.8f}));
    if (best.empty()) best = shares;
    EXPECT_EQ(shares, best) << name;
  }
}

}  // namespace
}  // namespace hair

// What docs/measurements.md promises of the density map's automatic settings, on real hair.
#include <filesystem>

#include <gtest/gtest.h>

#include <libhair/files/strand_file.h>
#include <libhair/measure/shadow/shadow_trial.h>
#include <libhair/shadow/density_map.h>

namespace hair {
namespace {

struct RealHair {
  const char* file;
  float width, opacity;
};
constexpr RealHair kStraight{"straight.hair", 0.465e-3f, 0.64f};
constexpr RealHair kSintel{"sintel.tfx", 0.15e-3f, 0.6f};

class Accuracy : public testing::TestWithParam<RealHair> {
 protected:
  void SetUp() override {
    const std::filesystem::path path =
        std::filesystem::path(HAIR_DATA_DIR) / "hair" / GetParam().file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    StrandFile read = readStrands(path, {});
    dropDegenerate(read, 1e-3f);
    strands = std::move(read.strands);
    fibre = {GetParam().width, GetParam().opacity, 1};
    tracer = makeGridTracer(strands, fibre);
  }
  std::vector<ShadowTrial> tried(const std::vector<ShadowCandidate>& candidates,
                                 const LightSpace& light, float footprint, std::size_t count,
                                 std::uint32_t rays) const {
    const auto points = chooseSamplePoints(strands, count, 5);
    const Truth truth = exactTransmittance(*tracer, fibre, light, points, {footprint, rays, 5});
    return runTrials(candidates, {strands, fibre, light, points, truth}, 1);
  }
  ShadowCandidate automatic(const LightSpace& light, float footprint) const {
    return {"auto", "auto", automaticMapSettings(strands, light, footprint)};
  }

  StrandSet strands;
  Fibre fibre;
  std::unique_ptr<FibreTracer> tracer;
};

const glm::vec3 kLight(0.5f, -0.8f, 0.35f);

TEST_P(Accuracy, OfTheAutomaticSettingsIsAsPromised) {
  const LightSpace light = makeLightSpace(kLight);
  const ErrorFigures e = tried({automatic(light, 3e-3f)}, light, 3e-3f, 3000, 512)[0].error;
  EXPECT_LE(e.meanAbsolute.value, 0.010);
  EXPECT_LE(e.rms.value, 0.020);
  EXPECT_LE(std::abs(e.bias.value), 0.003);
}

TEST_P(Accuracy, OfALampIsThatOfParallelLight) {
  const glm::vec3 middle = bounds(strands.points).centre();
  const LightSpace parallel = makeLightSpace(kLight);
  const LightSpace lamp = makePointLightSpace(middle - 0.6f * parallel.direction(), middle);
  const auto error = [&](const LightSpace& light) {
    return tried({automatic(light, 3e-3f)}, light, 3e-3f, 1000, 256)[0].error;
  };
  const ErrorFigures far = error(parallel), near = error(lamp);
  const double noise = 3 * (far.meanAbsolute.standardError + near.meanAbsolute.standardError);
  EXPECT_LE(near.meanAbsolute.value, far.meanAbsolute.value + noise);
  EXPECT_LE(std::abs(near.bias.value), 0.004);
}

TEST_P(Accuracy, OfTheAutomaticSettingsIsNearTheBestFixedOnes) {
  for (const glm::vec3 direction : {glm::vec3(0, -1, 0), glm::vec3(-1, -0.3f, 0.2f),
                                    glm::vec3(0.3f, -0.4f, -1), glm::vec3(0.2f, -0.5f, 1)})
    for (const float footprint : {3e-3f, 6e-3f}) {
      const LightSpace light = makeLightSpace(direction);
      std::vector<ShadowCandidate> candidates{automatic(light, footprint)};
      const float extent = extentSeen(strands, light);
      for (const float cell : {1e-3f, 1.5e-3f, 2e-3f, 3e-3f, 5e-3f, 7.5e-3f})
        for (const Filter filter : {Filter::Centred, Filter::Footprint}) {
          DensityMapSettings fixed;
          fixed.cellSize = cell;
          fixed.cells = static_cast<int>(extent / cell) + 20;
          fixed.filter = filter;
          fixed.footprint = footprint;
          candidates.push_back({"density map", text(cell, ' ', static_cast<int>(filter)), fixed});
        }
      const auto trials = tried(candidates, light, footprint, 800, 256);
      double best = INFINITY;
      for (std::size_t t = 1; t < trials.size(); ++t) {
        ASSERT_FALSE(trials[t].failed()) << trials[t].failure;
        best = std::min(best, trials[t].error.meanAbsolute.value);
      }
      EXPECT_LE(trials[0].error.meanAbsolute.value, 1.3 * best)
          << direction.x << ' ' << direction.y << ' ' << direction.z << ", footprint " << footprint;
    }
}

INSTANTIATE_TEST_SUITE_P(RealHair, Accuracy, testing::Values(kStraight, kSintel),
                         [](const auto& hair) {
                           return std::string(hair.param.file).substr(0, 6);
                         });

}  // namespace
}  // namespace hair

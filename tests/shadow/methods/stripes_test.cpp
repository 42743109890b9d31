#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/files/hair_file.h>
#include <libhair/measure/shadow/stripes.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/opacity_map.h>

#include "methods.h"

namespace hair {
namespace {

TEST(Stripes, HaveHalfTheSquareOfTheirAmplitude) {
  std::vector<float> depth, stripes, slower, constant;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const float x = 3.0f + 20.0f * uniform(i, 0);
    depth.push_back(x);
    stripes.push_back(0.4f + 0.1f * std::sin(2 * std::numbers::pi_v<float> * x / 0.5f + 1.0f));
    slower.push_back(0.1f * std::sin(2 * std::numbers::pi_v<float> * x / 4.0f));
    constant.push_back(0.4f);
  }
  EXPECT_NEAR(stripeEnergy(stripes, depth, 0.5), 0.005, 1e-6);
  EXPECT_NEAR(stripeEnergy(constant, depth, 0.5), 0, 1e-12);
  EXPECT_LT(stripeEnergy(slower, depth, 0.5), 2 * 0.005 * 10 / 4000);  // as noise
  EXPECT_LT(stripeEnergy(stripes, depth, 0.37), 2 * 0.005 * 10 / 4000);
}

TEST(Stripes, RefuseWhatCannotBeMeasured) {
  const std::vector<float> three{0, 0.3f, 0.6f}, two{0, 1}, same{1, 1, 1};
  EXPECT_NO_THROW(stripeEnergy(three, three, 1));
  EXPECT_THROW(stripeEnergy(three, two, 1), Error);
  EXPECT_THROW(stripeEnergy(two, two, 1), Error);
  EXPECT_THROW(stripeEnergy(three, three, 0), Error);
  EXPECT_THROW(stripeEnergy(three, three, NAN), Error);
  EXPECT_THROW(stripeEnergy(three, same, 1), Error);
  EXPECT_THROW(stripeEnergy(three, std::vector<float>{0, NAN, 1}, 1), Error);
}

/// Smooth, straight hair that hangs from a ball of 9 cm as a dome: strands down its meridians, in
/// `shells` shells of 1 mm.
StrandSet dome(std::uint32_t strands, int shells) {
  StrandSet hair;
  std::vector<glm::vec3> points(40);
  for (int shell = 0; shell < shells; ++shell)
    for (std::uint32_t s = 0; s < strands; ++s) {
      const auto item = static_cast<std::uint32_t>(shell) * strands + s;
      const float angle =
          6.2831853f * (static_cast<float>(s) + uniform(item, 0)) / static_cast<float>(strands);
      const float radius = 0.1f - 1e-3f * (static_cast<float>(shell) + uniform(item, 1));
      for (std::size_t k = 0; k < points.size(); ++k) {
        const float polar = 0.3f + 1.5f * static_cast<float>(k) / 39.0f;
        points[k] = radius * glm::vec3(std::sin(polar) * std::cos(angle), std::cos(polar),
                                       std::sin(polar) * std::sin(angle));
      }
      hair.append(points);
    }
  return hair;
}

/// Mean squares of the stripes at lit points, against 1024 slices.
struct Found {
  double of16Slices, of128Slices, of3Layers;  ///< at the distance of their own slices; 3: of the 16
  double noise;                               ///< of the 3 layers at distances that nothing has
};

Found stripesOf(StrandView hair, const Fibre& fibre, const LightSpace& light, float depth) {
  const LightImage image = makeLightImage(hair, light, 3e-3f);
  const auto slices = [&](int count) {
    OpacityMapSettings s;
    s.slices = count;
    return test::shadowed(*makeOpacityMap(s), hair, light, fibre);
  };
  DeepOpacityMapSettings deep;
  deep.layers = 3;
  deep.depth = depth;
  const auto truth = slices(1024), sixteen = slices(16), many = slices(128),
             three = test::shadowed(*makeDeepOpacityMap(deep), hair, light, fibre);
  // What a picture shows: points that light reaches.
  std::vector<float> depths, of16, of128, of3;
  for (std::size_t p = 0; p < hair.pointCount(); ++p) {
    if (truth[p] < 0.3f) continue;
    depths.push_back(image.frame.cellCoordinates(hair.points[p]).x);
    of16.push_back(sixteen[p] - truth[p]);
    of128.push_back(many[p] - truth[p]);
    of3.push_back(three[p] - truth[p]);
  }
  EXPECT_GT(depths.size(), 5000u);
  const double all = double{image.farthest - image.nearest};
  Found found{stripeEnergy(of16, depths, all / 16), stripeEnergy(of128, depths, all / 128),
              stripeEnergy(of3, depths, all / 16), 0};
  for (double perDepth : {13.3, 14.6, 17.7, 19.1})
    found.noise += stripeEnergy(of3, depths, all / perDepth) / 4;
  return found;
}

void record(const std::string& of, const Found& found) {
  testing::Test::RecordProperty(of + "_16_slices", text(found.of16Slices));
  testing::Test::RecordProperty(of + "_128_slices", text(found.of128Slices));
  testing::Test::RecordProperty(of + "_3_layers", text(found.of3Layers));
  testing::Test::RecordProperty(of + "_noise", text(found.noise));
}

/// Yuksel and Keyser 2008, figure 1: on smooth hair slices show as stripes, layers that follow the
/// hair do not.
TEST(Stripes, OfSixteenSlicesAreNotThereInThreeDeepLayers) {
  const StrandSet hair = dome(800, 12);
  for (const LightSpace& light : {test::parallelLight(), test::nearLight()}) {
    const Found found = stripesOf(hair, {80e-6f, 0.6f, 8}, light, 0.03f);
    record(light.atPoint() ? "point" : "parallel", found);
    EXPECT_GT(found.of16Slices, 1e-3);  // 3 % of the light, root mean square: plain to see
    EXPECT_GT(found.of16Slices, 100 * found.of3Layers);
    EXPECT_GT(found.of16Slices, 10 * found.of128Slices);
    EXPECT_LT(found.of3Layers, 4 * found.noise);
  }
}

/// The hair of that figure, if it is there.
TEST(Stripes, OfSixteenSlicesAreNotThereInThreeDeepLayersOfRealHair) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/straight.hair";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  StrandSet hair = readHair(file).strands;
  for (glm::vec3& p : hair.points) p = 0.00465f * glm::vec3(p.y, p.z, p.x);
  const Found found = stripesOf(hair, {80e-6f, 0.6f, 10}, test::parallelLight(), 0.05f);
  record("straight", found);
  EXPECT_GT(found.of16Slices, 1e-4);
  EXPECT_GT(found.of16Slices, 100 * found.of3Layers);
}

}  // namespace
}  // namespace hair

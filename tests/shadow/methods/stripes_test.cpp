#include <numbers>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/measure/stripes.h>

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
      const float angle = 6.2831853f * (static_cast<float>(s) + uniform(item, 0)) /
                          static_cast<float>(strands);
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

/// Yuksel and Keyser 2008, figure 1: on smooth hair slices show as stripes, layers that follow the
/// hair do not.
TEST(Stripes, OfSixteenSlicesAreNotThereInThreeDeepLayers) {
  const StrandSet hair = dome(800, 12);
  const Fibre fibre{80e-6f, 0.6f, 8};
  for (const LightSpace& light : {test::parallelLight(), test::nearLight()}) {
    const LightImage image = makeLightImage(hair, light, 3e-3f);
    const auto shadow = [&](ShadowMethod& method) {
      return test::shadowed(method, hair, light, fibre);
    };
    const auto slices = [&](int count) {
      OpacityMapSettings s;
      s.slices = count;
      return shadow(*makeOpacityMap(s));
    };
    DeepOpacityMapSettings deep;
    deep.layers = 3;
    deep.depth = 0.03f;
    const auto truth = slices(1024), sixteen = slices(16), many = slices(128),
               three = shadow(*makeDeepOpacityMap(deep));
    // What a picture shows: points that light reaches.
    std::vector<float> depth, of16, of128, of3;
    for (std::size_t p = 0; p < hair.pointCount(); ++p) {
      if (truth[p] < 0.3f) continue;
      depth.push_back(image.frame.cellCoordinates(hair.points[p]).x);
      of16.push_back(sixteen[p] - truth[p]);
      of128.push_back(many[p] - truth[p]);
      of3.push_back(three[p] - truth[p]);
    }
    ASSERT_GT(depth.size(), 5000u);
    const double all = double{image.farthest - image.nearest};
    const double e16 = stripeEnergy(of16, depth, all / 16);
    const double e128 = stripeEnergy(of128, depth, all / 128);
    const double e3 = stripeEnergy(of3, depth, all / 16);
    // What other frequencies hold: nothing of the method, all of the hair.
    double noise = 0;
    for (double slicesOf : {13.3, 14.6, 17.7, 19.1}) noise += stripeEnergy(of3, depth, all / slicesOf) / 4;
    const std::string of = light.atPoint() ? "point_" : "parallel_";
    RecordProperty(of + "16_slices", text(e16));
    RecordProperty(of + "128_slices", text(e128));
    RecordProperty(of + "3_layers", text(e3));
    RecordProperty(of + "noise", text(noise));
    EXPECT_GT(e16, 100 * e3);
    EXPECT_GT(e16, 10 * e128);
    EXPECT_LT(e3, 4 * noise);
  }
}

}  // namespace
}  // namespace hair

#include <gtest/gtest.h>

#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/opacity_map.h>
#include "methods.h"

namespace hair {
namespace {

using Deep = DeepOpacityMapSettings;

/// Straight hair across light along x, in all directions: 0.2 m wide, depth in [0, 0.1 m], denser
/// the deeper: optical depth `whole` · (x / 0.1 m)².
struct Cloud {
  static constexpr float kDepth = 0.1f, kWide = 0.2f;
  StrandSet hair;
  Fibre fibre{80e-6f, 0.5f, 1.0f};
  double whole = 0;

  explicit Cloud(std::uint32_t strands) {
    double area = 0;
    for (std::uint32_t s = 0; s < strands; ++s) {
      // Chords between two random points of the rim of a disc would crowd there; long lines through
      // the square do not, in its middle.
      const float x =
          kDepth * std::sqrt((static_cast<float>(s) + uniform(s, 0)) / static_cast<float>(strands));
      const float angle = 6.2831853f * uniform(s, 1), off = kWide * (uniform(s, 2) - 0.5f);
      const glm::vec3 along(0, std::cos(angle), std::sin(angle));
      const glm::vec3 middle(x, -off * along.z, off * along.y);
      const glm::vec3 ends[] = {middle - kWide * along, middle + kWide * along};
      hair.append(ends);
      area += 1;
    }
    // Lines evenly spread over offsets, per metre of offset: length per area in the middle.
    whole = area / double{kWide} * 80e-6 * 0.5;
  }

  double transmittance(float x) const {
    const double part = std::clamp(double{x / kDepth}, 0.0, 1.0);
    return std::exp(-whole * part * part);
  }
};

/// The largest difference from the exact, of means over the middle of the cloud at 50 depths.
double worstMean(const Cloud& cloud, ShadowMethod& method) {
  method.build(cloud.hair, cloud.fibre, test::alongX());
  double worst = 0;
  for (int step = 0; step <= 50; ++step) {
    const float x = Cloud::kDepth * 0.02f * static_cast<float>(step) + 1e-4f;
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 2000; ++i)
      points.push_back({x, 0.08f * (uniform(i, 3) - 0.5f), 0.08f * (uniform(i, 4) - 0.5f)});
    double sum = 0;
    for (float t : test::sampled(method, points)) sum += double{t};
    worst = std::max(worst, std::abs(sum / 2000 - cloud.transmittance(x)));
  }
  return worst;
}

TEST(OpacityMap, ConvergesToTheExponentialAsSlicesGrow) {
  const Cloud cloud(20000);
  EXPECT_GT(cloud.whole, 2);
  double last = 1;
  for (int slices : {1, 2, 4, 64}) {
    OpacityMapSettings s;
    s.pixelSize = 5e-3f;
    s.slices = slices;
    const double worst = worstMean(cloud, *makeOpacityMap(s));
    EXPECT_LT(worst, slices < 64 ? last * 0.7 : 0.01) << slices << " slices";
    RecordProperty("slices" + std::to_string(slices), std::to_string(worst));
    last = worst;
  }
}

TEST(DeepOpacityMap, ConvergesToTheExponentialAsLayersGrow) {
  const Cloud cloud(20000);
  double last = 1;
  for (int layers : {1, 2, 4, 64}) {
    Deep s;
    s.pixelSize = 5e-3f;
    s.layers = layers;
    s.growth = Deep::Growth::Constant;
    s.beyond = Deep::Beyond::LargerLayers;
    const double worst = worstMean(cloud, *makeDeepOpacityMap(s));
    EXPECT_LT(worst, layers < 64 ? last * 0.7 : 0.01) << layers << " layers";
    RecordProperty("layers" + std::to_string(layers), std::to_string(worst));
    last = worst;
  }
}

TEST(OpacityMap, PublishedExtinctionIsDarkerThanTheTruth) {
  const Cloud cloud(20000);
  OpacityMapSettings s;
  s.pixelSize = 5e-3f;
  s.slices = 64;
  s.extinction = Extinction::Published;
  EXPECT_GT(worstMean(cloud, *makeOpacityMap(s)), 0.05);
}

/// Strands along y at these depths, all in the middle row of pixels; light along x.
StrandSet pile(std::initializer_list<float> depths) {
  StrandSet strands;
  for (float x : depths)
    strands.append(std::vector<glm::vec3>{{x, 0, 1.5e-3f}, {x, 0.03f, 1.5e-3f}});
  return strands;
}

double opticalDepthAt(const ShadowMethod& method, float x) {
  const glm::vec3 p(x, 0.0155f, 1.5e-3f);
  return -std::log(double{test::sampled(method, std::span(&p, 1))[0]});
}

TEST(DeepOpacityMap, HairBeyondTheLastLayerIsIgnoredCountedThereOrNotBeyond) {
  // Layers of 10 mm together, hair at 0, 8 and 25 mm; each strand covers a third of its
  // pixels and leaves 1 - opacity / 3 = exp(-0.2) of their light.
  const StrandSet strands = pile({0, 0.008f, 0.025f});
  const Fibre fibre{1e-3f, 3 * (1 - std::exp(-0.2f)), 1};
  const auto at = [&](Deep::Beyond beyond, float x) {
    Deep s;
    s.layers = 2;
    s.growth = Deep::Growth::Constant;
    s.depth = 0.01f;
    s.beyond = beyond;
    const auto method = makeDeepOpacityMap(s);
    method->build(strands, fibre, test::alongX());
    return opticalDepthAt(*method, x);
  };
  using enum Deep::Beyond;
  EXPECT_NEAR(at(Ignored, 0.02f), 0.4, 1e-5);
  EXPECT_NEAR(at(Ignored, 0.1f), 0.4, 1e-5);
  EXPECT_NEAR(at(InLastLayer, 0.1f), 0.6, 1e-5);
  EXPECT_NEAR(at(InLastLayer, 0.02f), 0.6, 1e-5);    // shadows itself, in front of it
  EXPECT_NEAR(at(InLastLayer, 0.0075f), 0.4, 1e-5);  // 0.2, and half of 0.4
  EXPECT_NEAR(at(LargerLayers, 0.1f), 0.6, 1e-5);
  EXPECT_NEAR(at(LargerLayers, 0.0125f), 0.4, 1e-5);  // two layers of 12.5 mm
  EXPECT_NEAR(at(LargerLayers, 0.01875f), 0.5, 1e-5);
}

TEST(DeepOpacityMap, HairShadowsWhatIsRightBehindItHoweverFewBitsDepthsHave) {
  // Each strand in a pixel of its own, at any depth.
  StrandSet strands;
  std::vector<glm::vec3> behind;
  for (std::uint32_t s = 0; s < 300; ++s) {
    const float x = 0.3f * uniform(s, 7), z = 3e-3f * (static_cast<float>(s) + 0.5f);
    strands.append(std::vector<glm::vec3>{{x, 0, z}, {x, 0.03f, z}});
    behind.push_back({x + 1e-4f, 0.015f, z});
  }
  for (int bits : {8, 16, 32}) {
    Deep s;
    s.layers = 1;
    s.depth = 0.01f;
    s.depthBits = bits;
    s.filter = LateralFilter::Nearest;
    const auto method = makeDeepOpacityMap(s);
    method->build(strands, {}, test::alongX());
    // Layers of 10 mm: 0.1 mm into them 1 % of the strand, up to 0.3 m / 255 more with 8 bits.
    const double whole = 80e-6 * 30 * 0.6 / 3e-3, step = 0.3 / ((1 << std::min(bits, 20)) - 1);
    for (float t : test::sampled(*method, behind)) {
      const double part = -std::log(double{t}) / whole;
      ASSERT_GT(part, 0.0099) << bits;
      ASSERT_LT(part, 0.0101 + step / 0.01) << bits;
    }
  }
}

/// Yuksel and Keyser 2008, section 3: 8 bits of depth look the same. They darken, because depths
/// are rounded towards the light, by less than the few layers themselves are wrong.
TEST(DeepOpacityMap, EightBitsOfDepthCostLessThanFewLayersDo) {
  const StrandSet hair = test::headOfHair(400, 25);
  const auto shadow = [&](int layers, int bits) {
    Deep s;
    s.layers = layers;
    s.depthBits = bits;
    s.growth = layers > 7 ? Deep::Growth::Constant : Deep::Growth::Linear;
    s.beyond = layers > 7 ? Deep::Beyond::LargerLayers : Deep::Beyond::InLastLayer;
    return test::shadowed(*makeDeepOpacityMap(s), hair, test::parallelLight());
  };
  const auto difference = [](const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double{std::abs(a[i] - b[i])};
    return sum / static_cast<double>(a.size());
  };
  const auto truth = shadow(255, 32), exact = shadow(7, 32);
  const double wrong = difference(exact, truth);
  const double by8 = difference(shadow(7, 8), exact), by16 = difference(shadow(7, 16), exact);
  RecordProperty("layers", text(wrong));
  RecordProperty("bits8", text(by8));
  RecordProperty("bits16", text(by16));
  EXPECT_LT(by8, 0.5 * wrong);
  EXPECT_LT(by16, by8 / 50);
  EXPECT_GT(by16, 0);
}

}  // namespace
}  // namespace hair

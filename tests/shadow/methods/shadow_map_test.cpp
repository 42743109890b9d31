#include <gtest/gtest.h>

#include <libhair/shadow/methods/shadow_map.h>
#include "methods.h"

namespace hair {
namespace {

/// A mat of strands 0.25 mm apart across light along x, from 0 to 0.1 m in y and z.
StrandSet mat() {
  StrandSet strands;
  for (int s = 0; s <= 400; ++s) {
    const float z = 0.25e-3f * static_cast<float>(s);
    strands.append(std::vector<glm::vec3>{{0, 0, z}, {0, 0.1f, z}});
  }
  return strands;
}

TEST(ShadowMap, AMatIsDarkBehindAndLitInFront) {
  const auto method = makeShadowMap({});
  method->build(mat(), {}, test::alongX());
  std::vector<glm::vec3> front, behind;
  for (std::uint32_t i = 0; i < 500; ++i) {
    const float y = 0.01f + 0.08f * uniform(i, 1), z = 0.01f + 0.08f * uniform(i, 2);
    front.push_back({-0.1f * uniform(i, 0), y, z});
    behind.push_back({0.002f + 0.1f * uniform(i, 0), y, z});
  }
  for (float t : test::sampled(*method, front)) ASSERT_EQ(t, 1.0f);
  for (float t : test::sampled(*method, behind)) ASSERT_EQ(t, 0.0f);
}

TEST(ShadowMap, EdgesAreAsSoftAsTheFilterIsWide) {
  for (float radius : {2e-3f, 5e-3f, 10e-3f}) {
    ShadowMapSettings s;
    s.filterRadius = radius;
    const auto method = makeShadowMap(s);
    method->build(mat(), {}, test::alongX());
    // Means along the edge, against how far beyond it.
    const auto mean = [&](float beyond) {
      std::vector<glm::vec3> points;
      for (std::uint32_t i = 0; i < 400; ++i)
        points.push_back({0.05f, 0.1f + beyond, 0.02f + 0.06f * uniform(i, 0)});
      float sum = 0;
      for (float t : test::sampled(*method, points)) sum += t;
      return sum / 400;
    };
    EXPECT_EQ(mean(-radius - 1e-3f), 0.0f);
    EXPECT_EQ(mean(radius + 1.1e-3f), 1.0f);
    // The pixel in which the strands end is dark as a whole: the edge is up to a pixel out.
    EXPECT_NEAR(mean(0.5e-3f), 0.5f, 0.5e-3f / radius + 0.02f);
    float before = 0;
    for (int i = -10; i <= 10; ++i) {
      const float t = mean(radius * 0.1f * static_cast<float>(i));
      EXPECT_GE(t, before - 0.01f);
      before = t;
    }
  }
}

TEST(ShadowMap, TheFirstHairItselfIsLit) {
  StrandSet strands = mat();
  // Nearer to the light, elsewhere: or else the mat would be in front of all hair.
  strands.append(std::vector<glm::vec3>{{-0.05f, 0.3f, 0}, {-0.05f, 0.3f, 0.1f}});
  ShadowMapSettings s;
  s.bias = 0;
  const auto method = makeShadowMap(s);
  method->build(strands, {}, test::alongX());
  for (float behind : {0.0f, 1e-5f}) {
    const glm::vec3 p(behind, 0.05f, 0.05f);
    EXPECT_EQ(test::sampled(*method, std::span(&p, 1))[0], behind > 0 ? 0.0f : 1.0f);
  }
}

TEST(ShadowMap, ABiasKeepsASlantedMatFromShadowingItself) {
  const LightSpace light = makeLightSpace(glm::vec3(1, 0.7f, 0));  // 35 degrees off the normal
  const auto self = [&](float bias) {
    ShadowMapSettings s;
    s.bias = bias;
    const auto method = makeShadowMap(s);
    StrandSet strands = mat();
    method->build(strands, {}, light);
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 500; ++i)
      points.push_back({0, 0.02f + 0.06f * uniform(i, 1), 0.02f + 0.06f * uniform(i, 2)});
    float sum = 0;
    for (float t : test::sampled(*method, points)) sum += t;
    return sum / 500;
  };
  EXPECT_LT(self(0), 0.7f);      // acne: half of the disc lies nearer to the light
  EXPECT_EQ(self(5e-3f), 1.0f);  // radius 3 mm and half a pixel, times the slope, and rounding
}

}  // namespace
}  // namespace hair

#include <cstring>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/opacity_map.h>

#include "methods.h"

namespace hair {
namespace {

using test::candidates;
using test::headOfHair;
using test::nearLight;
using test::parallelLight;
using test::sampled;
using test::shadowed;

const StrandSet& hairs() {
  static const StrandSet hair = headOfHair(400, 25);
  return hair;
}

void expectSameBits(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0);
}

TEST(ImageMethods, TransmittanceIsAPartOfTheLight) {
  std::vector<glm::vec3> points = hairs().points;
  for (std::uint32_t i = 0; i < 5000; ++i)
    points.push_back(1.2f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.6f);
  for (const LightSpace& light : {parallelLight(), nearLight(), nearLight(0.5f)})
    for (const auto& candidate : candidates()) {
      SCOPED_TRACE(candidate.name);
      const auto method = candidate.make();
      method->build(hairs(), {}, light);
      float least = 1, most = 0;
      for (float t : sampled(*method, points)) {
        ASSERT_GE(t, 0.0f);
        ASSERT_LE(t, 1.0f);
        least = std::min(least, t), most = std::max(most, t);
      }
      EXPECT_LT(least, 0.5f);
      EXPECT_EQ(most, 1.0f);
    }
}

TEST(ImageMethods, PointsInFrontOfAllHairAndBesideItAreLit) {
  for (const LightSpace& light : {parallelLight(), nearLight()}) {
    std::vector<glm::vec3> lit;
    for (std::size_t p = 0; p < hairs().pointCount(); p += 7) {
      const glm::vec3 h = hairs().points[p], way = light.directionAt(h);
      lit.push_back(h - 1.0f * way);
      lit.push_back(h + 1.0f * anyNormal(way));
      lit.push_back(h - 1.0f * glm::cross(anyNormal(way), way) + 0.5f * way);
    }
    // Far from everything, on both sides.
    for (float far : {1e6f, -1e6f, 1e12f}) lit.push_back(far * anyNormal(light.direction()));
    for (const auto& candidate : candidates()) {
      SCOPED_TRACE(candidate.name);
      const auto method = candidate.make();
      method->build(hairs(), {}, light);
      for (float t : sampled(*method, lit)) ASSERT_EQ(t, 1.0f);
    }
  }
}

TEST(ImageMethods, PointsRightInFrontOfTheFirstHairAreLit) {
  // A wall of hair across light along x: no depth but its own.
  StrandSet wall;
  for (int s = 0; s < 100; ++s) {
    const float z = 1e-3f * (static_cast<float>(s) + 0.5f);
    wall.append(std::vector<glm::vec3>{{0, 0, z}, {0, 0.1f, z}});
  }
  const glm::vec3 front(-1e-5f, 0.05f, 0.05f), behind(0.1f, 0.05f, 0.05f);
  for (const auto& candidate : candidates()) {
    if (candidate.name == "density map") continue;  // its cells have depth
    SCOPED_TRACE(candidate.name);
    const auto method = candidate.make();
    method->build(wall, {}, test::alongX());
    EXPECT_EQ(sampled(*method, std::span(&front, 1))[0], 1.0f);
    EXPECT_LT(sampled(*method, std::span(&behind, 1))[0], 0.5f);
  }
}

TEST(ImageMethods, WithoutHairAllIsLit) {
  const StrandSet none;
  const StrandSet points = test::oneStrand({{0.01f, 0.02f, 0.03f}});  // a strand of no segments
  for (const auto& candidate : candidates()) {
    SCOPED_TRACE(candidate.name);
    const auto method = candidate.make();
    for (float t : sampled(*method, hairs().points)) ASSERT_EQ(t, 1.0f);  // never built
    for (const StrandSet* hair : {&none, &points}) {
      method->build(hairs(), {}, parallelLight());
      method->build(*hair, {}, parallelLight());
      for (float t : sampled(*method, hairs().points)) ASSERT_EQ(t, 1.0f);
      EXPECT_TRUE(sampled(*method, none.points).empty());
    }
  }
}

TEST(ImageMethods, ItGetsDarkerAlongTheLight) {
  for (const LightSpace& light : {test::alongX(), parallelLight(), nearLight()}) {
    // Rounding moves points of one ray across it, by 1e-7 m; nothing does along x.
    const float rounding = light.lightFromWorld == glm::mat3(1) ? 1e-6f : 1e-4f;
    std::vector<glm::vec3> rays;
    constexpr int kSteps = 200;
    for (std::size_t p = 0; p < hairs().pointCount(); p += 97) {
      const glm::vec3 h = hairs().points[p], way = light.directionAt(h);
      for (int s = 0; s < kSteps; ++s)
        rays.push_back(h + (-0.4f + 0.004f * static_cast<float>(s)) * way);
    }
    for (const auto& candidate : candidates()) {
      SCOPED_TRACE(candidate.name);
      // Its filter is the pixels whose middles lie in a disc: they change in steps.
      if (candidate.name == "shadow map" && rounding > 1e-6f) continue;
      // So do nearest pixels.
      if (candidate.name.ends_with("filter 1") && rounding > 1e-6f) continue;
      const auto method = candidate.make();
      method->build(hairs(), {}, light);
      const auto t = sampled(*method, rays);
      for (std::size_t i = 1; i < t.size(); ++i)
        if (i % kSteps != 0) {
          ASSERT_LE(t[i], t[i - 1] + rounding);
        }
    }
  }
}

TEST(ImageMethods, AnyNumberOfThreadsGivesTheSameBits) {
  for (const LightSpace& light : {parallelLight(), nearLight()})
    for (const auto& candidate : candidates()) {
      SCOPED_TRACE(candidate.name);
      std::vector<float> alone;
      for (int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        const auto method = candidate.make();
        const auto t = shadowed(*method, hairs(), light);
        if (threads == 1) alone = t;
        expectSameBits(t, alone);
      }
    }
}

TEST(ImageMethods, RebuildingEqualsAFreshBuild) {
  const StrandSet small = headOfHair(50, 12, 0.1f, glm::vec3(0.02f, -0.1f, 0.05f));
  for (const auto& candidate : candidates()) {
    SCOPED_TRACE(candidate.name);
    const auto used = candidate.make();
    struct Scene {
      const StrandSet& hair;
      LightSpace light;
    };
    for (const Scene& scene :
         {Scene{hairs(), parallelLight()}, Scene{small, nearLight()}, Scene{hairs(), nearLight()},
          Scene{small, test::alongX()}, Scene{hairs(), parallelLight()}}) {
      const auto fresh = candidate.make();
      expectSameBits(shadowed(*used, scene.hair, scene.light),
                     shadowed(*fresh, scene.hair, scene.light));
      EXPECT_EQ(used->bytes(), fresh->bytes());
    }
  }
}

TEST(ImageMethods, ALightFarAwayIsParallelLight) {
  const LightSpace parallel = parallelLight();
  const LightSpace far = nearLight(1e4f);
  const LightSpace near = nearLight(0.5f);
  for (const auto& candidate : candidates()) {
    SCOPED_TRACE(candidate.name);
    const auto method = candidate.make();
    const auto expected = shadowed(*method, hairs(), parallel);
    const auto difference = [&](const LightSpace& light) {
      const auto t = shadowed(*method, hairs(), light);
      double sum = 0;
      for (std::size_t i = 0; i < t.size(); ++i) sum += double{std::abs(t[i] - expected[i])};
      return sum / static_cast<double>(t.size());
    };
    EXPECT_LT(difference(far), 1e-3);
    EXPECT_GT(difference(near), 1e-2);
  }
}

TEST(ImageMethods, StateWhatTheyHold) {
  // One more slice is one more word a pixel.
  const auto bytes = [](int slices) {
    OpacityMapSettings s;
    s.slices = slices;
    const auto method = makeOpacityMap(s);
    method->build(hairs(), {}, parallelLight());
    return method->bytes();
  };
  const std::size_t pixels = makeLightImage(hairs(), parallelLight(), 3e-3f).pixelCount();
  EXPECT_EQ(bytes(1), 4 * pixels);
  EXPECT_EQ(bytes(16), 64 * pixels);
  DeepOpacityMapSettings s;
  s.layers = 3;
  const auto deep = makeDeepOpacityMap(s);
  EXPECT_EQ(deep->bytes(), 0u);
  deep->build(hairs(), {}, parallelLight());
  EXPECT_EQ(deep->bytes(), 16 * pixels);  // the paper's single texture of four channels
}

}  // namespace
}  // namespace hair

// The methods against those of literal.h: no walk, no table, no integers.

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/literal.h>

#include "methods.h"

namespace hair {
namespace {

using test::nearLight;
using test::parallelLight;
using Deep = DeepOpacityMapSettings;

struct Scene {
  StrandSet hair = test::headOfHair(80, 14);  // and a few strands of many points, below
  Fibre fibre{80e-6f, 0.6f, 12.0f};
  LightSpace light;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all(2);
  const StrandSet fine = test::headOfHair(4, 150, 0.2f);
  for (Scene& scene : all)
    for (std::size_t s = 0; s < fine.strandCount(); ++s) scene.hair.append(fine.strand(s));
  all[0].light = parallelLight();
  all[1].light = nearLight(0.6f);
  return all;
}

template <class Settings>
void expectLike(const Scene& scene, ShadowMethod& method, const Settings& settings) {
  method.build(scene.hair, scene.fibre, scene.light);
  std::vector<glm::vec3> points;
  for (std::size_t p = 0; p < scene.hair.pointCount(); p += 5)
    points.push_back(scene.hair.points[p]);
  for (std::uint32_t i = 0; i < 60; ++i)
    points.push_back(0.4f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.2f);
  const auto measured = test::sampled(method, points);
  const auto expected =
      literal::transmittance(scene.hair, scene.fibre, scene.light, settings, points);
  int shadowed = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    ASSERT_NEAR(double{measured[p]}, expected[p], 1e-5) << "point " << p;
    shadowed += expected[p] < 0.9 ? 1 : 0;
  }
  EXPECT_GT(shadowed, 30);
}

TEST(OpacityMap, IsTheSumOverTheFragmentsOfAPixel) {
  for (const Scene& scene : scenes())
    for (LateralFilter filter : {LateralFilter::Nearest, LateralFilter::Linear})
      for (Extinction extinction : {Extinction::Unbiased, Extinction::Published})
        for (int slices : {1, 7, 64}) {
          SCOPED_TRACE(text(slices, " slices, filter ", static_cast<int>(filter)));
          const OpacityMapSettings s{5e-3f, slices, extinction, filter};
          expectLike(scene, *makeOpacityMap(s), s);
        }
}

TEST(DeepOpacityMap, IsTheSumOverTheFragmentsOfAPixel) {
  for (const Scene& scene : scenes())
    for (auto growth : {Deep::Growth::Constant, Deep::Growth::Linear, Deep::Growth::Doubling,
                        Deep::Growth::Fibonacci})
      for (auto beyond :
           {Deep::Beyond::Ignored, Deep::Beyond::InLastLayer, Deep::Beyond::LargerLayers}) {
        SCOPED_TRACE(
            text("growth ", static_cast<int>(growth), ", beyond ", static_cast<int>(beyond)));
        const Deep s{5e-3f, 5, growth, beyond, 0.04f};
        expectLike(scene, *makeDeepOpacityMap(s), s);
      }
}

TEST(ShadowMap, IsTheShareOfThePixelsInADiscThatSeeThePoint) {
  for (const Scene& scene : scenes())
    for (float radius : {0.0f, 4e-3f, 15e-3f}) {
      const ShadowMapSettings s{5e-3f, radius, 2e-3f};
      const auto method = makeShadowMap(s);
      method->build(scene.hair, scene.fibre, scene.light);
      const auto measured = test::sampled(*method, scene.hair.points);
      const auto expected = literal::transmittance(scene.hair, scene.light, s, scene.hair.points);
      int between = 0;
      for (std::size_t p = 0; p < scene.hair.pointCount(); ++p) {
        ASSERT_NEAR(double{measured[p]}, expected[p], 1e-6) << p;
        between += expected[p] > 0 && expected[p] < 1 ? 1 : 0;
      }
      EXPECT_EQ(between > 100, radius > 0);
    }
}

}  // namespace
}  // namespace hair

#include <limits>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/opacity_map.h>

#include "methods.h"

namespace hair {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

template <class Settings, class Make, class Value, class... Bad>
void expectRefused(Make make, Value Settings::* field, Bad... bad) {
  EXPECT_NO_THROW(make(Settings{}));
  for (Value value : {static_cast<Value>(bad)...}) {
    Settings settings;
    settings.*field = value;
    EXPECT_THROW(make(settings), Error) << static_cast<float>(value);
  }
}

TEST(ImageMethods, RefuseSettingsOutOfRange) {
  using Deep = DeepOpacityMapSettings;
  expectRefused(makeShadowMap, &ShadowMapSettings::pixelSize, 0, -1e-3f, kNaN, kInfinite);
  expectRefused(makeShadowMap, &ShadowMapSettings::filterRadius, -1e-3f, kNaN, kInfinite, 1.0f);
  expectRefused(makeShadowMap, &ShadowMapSettings::bias, -1e-3f, kNaN, kInfinite);
  expectRefused(makeOpacityMap, &OpacityMapSettings::pixelSize, 0, -1e-3f, kNaN, kInfinite);
  expectRefused(makeOpacityMap, &OpacityMapSettings::slices, 0, -1, 1025);
  expectRefused(makeDeepOpacityMap, &Deep::pixelSize, 0, -1e-3f, kNaN, kInfinite);
  expectRefused(makeDeepOpacityMap, &Deep::layers, 0, -1, 256);
  expectRefused(makeDeepOpacityMap, &Deep::depth, 0, -1e-3f, kNaN, kInfinite);
  expectRefused(makeDeepOpacityMap, &Deep::depthBits, 0, 7, 24, 64);
  int DensityMapSettings::* const cells = &DensityMapSettings::cells;
  expectRefused(makeDensityMapMethod, cells, 1, 1025);
  // Two hundred layers are fine, but not if each is twice as thick as the last.
  Deep many;
  many.layers = 200;
  EXPECT_NO_THROW(makeDeepOpacityMap(many));
  many.growth = Deep::Growth::Doubling;
  EXPECT_THROW(makeDeepOpacityMap(many), Error);
}

TEST(ImageMethods, RefuseFibresThatAreNone) {
  const StrandSet hair = test::headOfHair(10, 5);
  for (const auto& candidate : test::candidates())
    for (const Fibre& fibre : {Fibre{-1e-5f, 0.5f, 1}, Fibre{kNaN, 0.5f, 1}, Fibre{1e-5f, -1, 1},
                               Fibre{1e-5f, kNaN, 1}, Fibre{1e-5f, 0.5f, kInfinite}})
      EXPECT_THROW(candidate.make()->build(hair, fibre, test::parallelLight()), Error)
          << candidate.name;
}

TEST(ImageMethods, RefuseImagesTooLargeAndKeepWhatTheyHad) {
  const StrandSet hair = test::headOfHair(50, 12);
  StrandSet large = hair;
  large.append(std::vector<glm::vec3>{{0, 0, 0}, {100, 100, 100}});
  for (const auto& candidate : test::candidates()) {
    SCOPED_TRACE(candidate.name);
    const auto method = candidate.make();
    const auto before = test::shadowed(*method, hair, test::parallelLight());
    EXPECT_THROW(method->build(large, {}, test::parallelLight()), Error);
    if (candidate.name != "density map") {
      EXPECT_EQ(test::sampled(*method, hair.points), before);
    }
  }
  // Few enough pixels, but not with so many slices.
  OpacityMapSettings s;
  s.pixelSize = 0.1e-3f;
  s.slices = 1024;
  const auto method = makeOpacityMap(s);
  const auto lock = test::oneStrand({{0, 0, 0}, {0.003f, 0.004f, 0.003f}, {0.006f, 0, 0.004f}});
  const auto before = test::shadowed(*method, lock, test::parallelLight());
  EXPECT_THROW(method->build(hair, {}, test::parallelLight()), Error);
  EXPECT_EQ(test::sampled(*method, lock.points), before);
}

TEST(ImageMethods, RefuseRoomForAnotherNumberOfPoints) {
  const StrandSet hair = test::headOfHair(10, 5);
  std::vector<float> few(3);
  for (const auto& candidate : test::candidates())
    EXPECT_THROW(candidate.make()->sample(hair.points, few), Error) << candidate.name;
}

}  // namespace
}  // namespace hair

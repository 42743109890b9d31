#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/opacity_map.h>

#include "methods.h"

namespace hair {
namespace {

const std::vector<ShadowSettings>& everyMethod() {
  static const std::vector<ShadowSettings> all{
      DensityMapSettings{},     ShadowMapSettings{},         OpacityMapSettings{},
      DeepOpacityMapSettings{}, DensityClusteringSettings{}, DeepShadowMapSettings{}};
  return all;
}

TEST(ShadowMethod, EveryKindOfSettingsMakesItsMethod) {
  const StrandSet hair = test::headOfHair(200, 20);
  for (const ShadowSettings& settings : everyMethod()) {
    SCOPED_TRACE(methodName(settings));
    const auto t = test::shadowed(*makeShadowMethod(settings), hair, test::parallelLight());
    float least = 1;
    for (float v : t) {
      ASSERT_TRUE(v >= 0 && v <= 1);
      least = std::min(least, v);
    }
    EXPECT_LT(least, 0.5f);
  }
}

TEST(ShadowMethod, IsTheMethodThatItsOwnMakerMakes) {
  const StrandSet hair = test::headOfHair(200, 20);
  OpacityMapSettings settings;
  settings.slices = 5;
  EXPECT_EQ(test::shadowed(*makeShadowMethod(settings), hair, test::parallelLight()),
            test::shadowed(*makeOpacityMap(settings), hair, test::parallelLight()));
  settings.slices = 0;
  EXPECT_THROW(makeShadowMethod(settings), Error);
}

TEST(ShadowMethod, NamesDiffer) {
  for (const ShadowSettings& a : everyMethod())
    for (const ShadowSettings& b : everyMethod())
      EXPECT_EQ(methodName(a) == methodName(b), a.index() == b.index());
}

TEST(ShadowMethod, SettingsAreAFewWordsWithoutCommas) {
  for (const ShadowSettings& settings : everyMethod()) {
    const std::string words = settingsText(settings);
    EXPECT_EQ(words.find(','), std::string::npos);
    EXPECT_NE(words.find(" mm"), std::string::npos) << words;
    EXPECT_NE(words.front(), ' ');
    EXPECT_NE(words.back(), ' ');
    EXPECT_EQ(words.find("  "), std::string::npos) << words;
  }
  DeepOpacityMapSettings deep;
  EXPECT_EQ(settingsText(deep), "3 mm 7 layers linear over 50 mm");
  deep.layers = 1;
  deep.growth = DeepOpacityMapSettings::Growth::Fibonacci;
  deep.beyond = DeepOpacityMapSettings::Beyond::LargerLayers;
  deep.depthBits = 8;
  deep.extinction = Extinction::Published;
  deep.filter = LateralFilter::Nearest;
  EXPECT_EQ(settingsText(deep),
            "3 mm 1 layer fibonacci over all 8 bits published extinction nearest");
  EXPECT_EQ(settingsText(OpacityMapSettings{}), "3 mm 16 slices");
  EXPECT_EQ(settingsText(ShadowMapSettings{}), "1 mm radius 3 mm bias 1 mm");
  EXPECT_EQ(settingsText(DensityMapSettings{}), "7.5 mm 128 cells");
}

}  // namespace
}  // namespace hair

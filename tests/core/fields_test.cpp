#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/model/styles.h>
#include <libhair/shadow/methods/shadow_method.h>
#include <libhair/simulation/frame.h>
#include <libhair/wisps/bind.h>

namespace hair {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Range, IsWhatItsTextSays) {
  constexpr Range range("[-1.5, 2e3) m");
  static_assert(range.least() == -1.5 && range.most() == 2000);
  EXPECT_EQ(range.text(), "[-1.5, 2e3) m");
  EXPECT_TRUE(range.holds(-1.5f));
  EXPECT_FALSE(range.holds(std::nextafter(-1.5f, -2.0f)));
  EXPECT_TRUE(range.holds(std::nextafter(2000.0f, 0.0f)));
  EXPECT_FALSE(range.holds(2000.0f));
  constexpr Range open("(0, 1]");
  EXPECT_FALSE(open.holds(0.0f));
  EXPECT_TRUE(open.holds(std::numeric_limits<float>::denorm_min()));
  EXPECT_TRUE(open.holds(1.0f));
  constexpr Range unbounded("(0, inf)");
  EXPECT_TRUE(unbounded.holds(std::numeric_limits<float>::max()));
  EXPECT_FALSE(unbounded.holds(kInfinity));
}

TEST(Range, EndsAreTheFloatsThatTheirDigitsMean) {
  EXPECT_TRUE(Range("[0.1, 1]").holds(0.1f));
  EXPECT_TRUE(Range("[1e-5, 1]").holds(1e-5f));
  EXPECT_TRUE(Range("[1e-12, 1]").holds(1e-12f));
  EXPECT_FALSE(Range("[0, 0.1)").holds(0.1f));
  EXPECT_TRUE(Range("[0, 1e30]").holds(1e30f));
}

TEST(Range, NothingButAFieldWithoutOneTakesNaN) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Range("[0, inf)").holds(nan));
  EXPECT_FALSE(Range("[0, 10) m").holds(glm::vec3(0, nan, 0)));
  EXPECT_FALSE(Range("[0, 10) each").holds(glm::vec3(0, nan, 0)));
  EXPECT_TRUE(Range().holds(nan));
}

TEST(Range, OfAVectorIsThatOfItsLengthOrOfEachComponent) {
  EXPECT_TRUE(Range("[0, 10) m").holds(glm::vec3(-9, 0, 0)));
  EXPECT_FALSE(Range("[0, 10) m").holds(glm::vec3(-8, 0, 8)));
  EXPECT_FALSE(Range("[0, 10] each").holds(glm::vec3(-1, 0, 8)));
  EXPECT_TRUE(Range("[0, 10] each").holds(glm::vec3(8, 10, 8)));
}

TEST(Fields, NamesInCAndPython) {
  EXPECT_EQ(snakeCase("strandStride"), "strand_stride");
  EXPECT_EQ(snakeCase("skin"), "skin");
}

// The public check of settings, or the table alone where their maker checks them.
template <class S>
void check(const S& settings) {
  if constexpr (requires { validate(settings); })
    validate(settings);
  else
    validateFields(settings, "settings");
}

template <class S>
std::string refusal(const S& settings) {
  try {
    check(settings);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

template <class S>
class EveryField : public testing::Test {};

using Settings =
    testing::Types<GuideSettings, RepulsionSettings, Wind, WispSettings, DensityGridSettings,
                   DensityMapSettings, KajiyaKaySettings, FrameSettings, Fibre, BindSettings,
                   LevelOfDetail, DetailSettings, Parting, StyleSettings, PilotSettings,
                   ShadowMapSettings, OpacityMapSettings, DeepOpacityMapSettings,
                   DensityClusteringSettings, DeepShadowMapSettings>;
TYPED_TEST_SUITE(EveryField, Settings);

TYPED_TEST(EveryField, HasADefaultInItsRange) {
  EXPECT_EQ(refusal(TypeParam{}), "");
}

// One number past either end is refused, with the field's name and its range in the message.
TYPED_TEST(EveryField, IsRefusedOutsideItsRange) {
  forFields<TypeParam>([](const auto& field) {
    using M = std::remove_cvref_t<decltype(TypeParam{}.*field.member)>;
    SCOPED_TRACE(field.name);
    const Range& range = field.range;
    const auto expectRefused = [&](M value) {
      TypeParam settings;
      settings.*field.member = value;
      const std::string message = refusal(settings);
      EXPECT_NE(message.find(text(field.name, " = ")), std::string::npos) << message;
      EXPECT_NE(message.find(range.text()), std::string::npos) << message;
    };
    if constexpr (std::is_same_v<M, float>) {
      const auto least = static_cast<float>(range.least()), most = static_cast<float>(range.most());
      expectRefused(range.holds(least) ? std::nextafter(least, -kInfinity) : least);
      expectRefused(range.holds(most) ? std::nextafter(most, kInfinity) : most);
      expectRefused(std::numeric_limits<float>::quiet_NaN());
    } else if constexpr (std::is_same_v<M, glm::vec3>) {
      expectRefused({0, static_cast<float>(2 * range.most()), 0});
      expectRefused(glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    } else if constexpr (std::is_integral_v<M> && !std::is_same_v<M, bool>) {
      if (range.text().empty()) return;
      if (range.least() > 0) expectRefused(static_cast<M>(range.least() - 1));
      if (range.most() < 1e6) expectRefused(static_cast<M>(range.most() + 1));
    } else if constexpr (HasWords<M>) {
      TypeParam settings;
      settings.*field.member = static_cast<M>(99);
      EXPECT_NE(refusal(settings).find(allWords<M>()), std::string::npos) << refusal(settings);
    }
  });
}

TEST(Words, AreUniqueAndComeBack) {
  for (const auto& word : wordsOf(Filter{})) EXPECT_EQ(wordOf(word.value), word.word);
  EXPECT_EQ(allWords<LinkSolver>(), "direct, relaxation");
  EXPECT_EQ(wordOf(static_cast<Filter>(77)), "");
}

}  // namespace
}  // namespace hair

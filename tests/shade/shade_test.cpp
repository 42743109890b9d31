#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/shade/appearance.h>
#include <libhair/shade/literal.h>
#include <libhair/shade/srgb.h>

namespace hair {
namespace {

/// One parallel light, and the eye.
struct WhiteLight {
  glm::vec3 direction{0, -1, 0};
  glm::vec3 eye{0, 0, 1};
};

/// White hair with one white light: what comes out is the bare model.
KajiyaKaySettings bare(float ambient, float diffuse, float specular) {
  KajiyaKaySettings settings = KajiyaKaySettings::plain();
  settings.rootColour = settings.tipColour = glm::vec3(1);
  settings.ambient = ambient;
  settings.diffuse = diffuse;
  settings.specular = specular;
  return settings;
}

StrandSet straight(glm::vec3 direction, int points = 5) {
  StrandSet strands;
  std::vector<glm::vec3> p;
  for (int k = 0; k < points; ++k) p.push_back(0.01f * static_cast<float>(k) * direction);
  strands.append(p);
  return strands;
}

int red(std::uint32_t colour) {
  return static_cast<int>(colour & 255u);
}
int green(std::uint32_t colour) {
  return static_cast<int>(colour >> 8 & 255u);
}
int blue(std::uint32_t colour) {
  return static_cast<int>(colour >> 16 & 255u);
}

std::vector<std::uint32_t> shadeAll(StrandView strands, const WhiteLight& light,
                                    const KajiyaKaySettings& settings,
                                    const std::vector<float>& t = {},
                                    const std::vector<float>& v = {}) {
  std::vector<std::uint32_t> out(strands.pointCount());
  const Light parallel = Light::parallel(light.direction);
  shade(strands, {{&parallel, 1}, glm::vec3(0), light.eye, t, v}, settings, {}, out);
  return out;
}

int byteOf(float linear) {
  return static_cast<int>(std::lround(255 * srgbFromLinear(linear)));
}

TEST(Srgb, IsExactAtItsEndsAndCloseBetween) {
  const SrgbTable& table = SrgbTable::get();
  EXPECT_EQ(table(0.0f), 0);
  EXPECT_EQ(table(1.0f), 255);
  EXPECT_EQ(table(-3.0f), 0);
  EXPECT_EQ(table(1e9f), 255);
  EXPECT_EQ(table(NAN), 0);
  EXPECT_EQ(table(std::nextafter(1.0f, 0.0f)), 255);
  int before = 0;
  for (int i = 0; i <= 100000; ++i) {
    const float x = static_cast<float>(i) * 1e-5f;
    ASSERT_NEAR(table(x), 255 * srgbFromLinear(x), 0.65) << x;
    ASSERT_GE(table(x), before);
    before = table(x);
  }
  // Every byte comes back from the linear value that it stands for.
  for (int b = 0; b < 256; ++b) {
    const double s = b / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    EXPECT_EQ(table(static_cast<float>(linear)), b);
  }
}

TEST(KajiyaKay, LightAlongTheTangentGivesNoDiffuseLight) {
  const StrandSet strand = straight({0, -1, 0});
  WhiteLight light;
  light.direction = {0, -1, 0};
  light.eye = {0, 0, 10};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 1, 0))) EXPECT_LE(red(c), 2);
  // And across it all of it; in between the sine.
  light.direction = {0, 0, -1};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 0.5f, 0)))
    EXPECT_NEAR(red(c), byteOf(0.5f), 1);
  light.direction = {0, -0.8f, -0.6f};
  for (std::uint32_t c : shadeAll(strand, light, bare(0, 0.5f, 0)))
    EXPECT_NEAR(red(c), byteOf(0.3f), 1);
}

TEST(KajiyaKay, HighlightPeaksOnTheConeOfTheMirroredRay) {
  // The strand runs along x through the origin; light falls in at 30 degrees off its normal and
  // leaves at 30 degrees to the other side, in every direction around the strand.
  const StrandSet strand = straight({1, 0, 0}, 3);
  WhiteLight light;
  light.direction = glm::normalize(glm::vec3(std::sin(0.5236f), -std::cos(0.5236f), 0));
  const auto seenAt = [&](float angle, float around, const KajiyaKaySettings& settings) {
    light.eye = 1000.0f * glm::vec3(std::sin(angle), std::cos(angle) * std::cos(around),
                                    std::cos(angle) * std::sin(around));
    return red(shadeAll(strand, light, settings)[0]);
  };
  for (float around : {0.0f, 1.0f, 2.5f}) {
    const auto settings = bare(0, 0, 0.8f);
    EXPECT_NEAR(seenAt(0.5236f, around, settings), byteOf(0.8f), 1);
    EXPECT_NEAR(seenAt(0.5236f + 0.2f, around, settings),
                byteOf(0.8f * std::pow(std::cos(0.2f), settings.exponent)), 2);
    EXPECT_NEAR(seenAt(0.5236f - 0.2f, around, settings),
                byteOf(0.8f * std::pow(std::cos(0.2f), settings.exponent)), 2);
  }
  // Shifted towards the tip (+x): the eye must look less from the tip's side to see the peak.
  auto shifted = bare(0, 0, 0.8f);
  shifted.firstShift = 0.1f;
  const float toRoot = 0.5236f - 0.1f, toTip = 0.5236f + 0.1f;
  EXPECT_NE(seenAt(toRoot, 0, shifted), seenAt(toTip, 0, shifted));
  EXPECT_NEAR(std::max(seenAt(toRoot, 0, shifted), seenAt(toTip, 0, shifted)), byteOf(0.8f), 1);
}

TEST(KajiyaKay, SecondHighlightLiesNearerToTheTipAndHasTheHairsColour) {
  // Hair over a crown, lit from above, seen from the front: from horizontal at the root to
  // hanging at the tip.
  StrandSet strand;
  std::vector<glm::vec3> p;
  for (int k = 0; k <= 400; ++k) {
    const float a = 1.5707963f * static_cast<float>(k) / 400;
    p.push_back(0.1f * glm::vec3(0, std::cos(a), std::sin(a)));
  }
  strand.append(p);
  WhiteLight light;
  light.direction = {0, -1, 0};
  light.eye = {0, 0, 1000};
  const auto peak = [&](KajiyaKaySettings settings) {
    const auto colours = shadeAll(strand, light, settings);
    std::size_t sum = 0, weight = 0;
    for (std::size_t k = 0; k < colours.size(); ++k)
      if (red(colours[k]) > 120) sum += k, ++weight;
    EXPECT_GT(weight, 0u);
    return static_cast<double>(sum) / static_cast<double>(weight);
  };
  KajiyaKaySettings first;
  first.ambient = first.diffuse = first.secondSpecular = first.variation = 0;
  first.specular = 1;
  KajiyaKaySettings second = first;
  second.specular = 0;
  second.secondSpecular = 1;
  second.secondExponent = 48;
  second.rootColour = second.tipColour = {1, 0, 0};
  const double plainPeak = peak([&] {
    auto s = first;
    s.firstShift = 0;
    return s;
  }());
  EXPECT_NEAR(plainPeak, 200, 2);
  EXPECT_LT(peak(first), plainPeak - 3);
  EXPECT_GT(peak(second), plainPeak + 3);
  for (std::uint32_t c : shadeAll(strand, light, second)) EXPECT_EQ(green(c) + blue(c), 0);
}

TEST(KajiyaKay, BrightnessGrowsWithTransmittanceFromAmbientToFull) {
  const StrandSet strand = straight({0, 1, 0}, 200);
  std::vector<float> t(200), ones(200, 1.0f);
  for (int k = 0; k < 200; ++k) t[static_cast<std::size_t>(k)] = static_cast<float>(k) / 199;
  WhiteLight light;
  light.direction = {0, 0, -1};
  light.eye = {0, 1, 100};
  const auto settings = bare(0.1f, 0.5f, 0.2f);
  const auto colours = shadeAll(strand, light, settings, t);
  for (std::size_t k = 1; k < colours.size(); ++k) ASSERT_GE(red(colours[k]), red(colours[k - 1]));
  EXPECT_NEAR(red(colours.front()), byteOf(0.1f), 1);
  EXPECT_NEAR(red(colours.back()), byteOf(0.8f), 1);
  // No shadows: the same as full transmittance. Visibility: the same as transmittance.
  EXPECT_EQ(shadeAll(strand, light, settings), shadeAll(strand, light, settings, ones, ones));
  EXPECT_EQ(colours, shadeAll(strand, light, settings, {}, t));
}

TEST(KajiyaKay, ColourRunsFromRootToTipAndVariesByStrandAroundIt) {
  StrandSet strands;
  for (int s = 0; s < 400; ++s)
    strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.1f, 0}, {0, 0.2f, 0}});
  auto settings = bare(1, 0, 0);
  settings.rootColour = {0.2f, 0.4f, 0.1f};
  settings.tipColour = {0.6f, 0.2f, 0.3f};
  const auto same = shadeAll(strands, {}, settings);
  EXPECT_EQ(red(same[0]), byteOf(0.2f));
  EXPECT_EQ(green(same[1]), byteOf(0.3f));
  EXPECT_EQ(blue(same[2]), byteOf(0.3f));
  EXPECT_EQ(same[0] >> 24, 255u);
  EXPECT_EQ(same[3], same[0]);
  settings.variation = 0.5f;
  const auto varied = shadeAll(strands, {}, settings);
  int least = 255, most = 0;
  for (std::size_t s = 0; s < 400; ++s) {
    least = std::min(least, red(varied[3 * s]));
    most = std::max(most, red(varied[3 * s]));
  }
  EXPECT_NEAR(least, byteOf(0.1f), 3);
  EXPECT_NEAR(most, byteOf(0.3f), 3);
}

TEST(KajiyaKay, HasTheSameBitsForAnyThreadCountAndForStrandsAlone) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < 1000; ++s) {
    std::vector<glm::vec3> p;
    for (std::uint32_t k = 0; k < 1 + s % 40; ++k)
      p.push_back({uniform(s, k), uniform(s, k, 1), uniform(s, k, 2)});
    strands.append(p);
  }
  std::vector<std::uint32_t> first;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const auto colours = shadeAll(strands, {}, {});
    if (first.empty()) first = colours;
    EXPECT_EQ(colours, first);
  }
  auto settings = KajiyaKaySettings();
  settings.variation = 0;
  const auto together = shadeAll(strands, {}, settings);
  for (std::size_t s = 0; s < 100; ++s) {
    StrandSet alone;
    alone.append(strands.strand(s));
    const auto colours = shadeAll(alone, {}, settings);
    for (std::size_t k = 0; k < colours.size(); ++k)
      ASSERT_EQ(colours[k], together[strands.first[s] + k]);
  }
}

// Strands of the lengths at which blocks of sixteen begin and end.
StrandSet ofManyLengths() {
  StrandSet strands;
  for (std::uint32_t s = 0; s < 300; ++s) {
    constexpr std::uint32_t kCounts[] = {2, 15, 16, 17, 33, 1, 130};
    std::vector<glm::vec3> p;
    for (std::uint32_t k = 0; k < kCounts[s % 7]; ++k)
      p.push_back({uniform(s, k), uniform(s, k, 1), uniform(s, k, 2)});
    strands.append(p);
  }
  return strands;
}

/// Strands under two lights, each with shadows of both kinds.
struct Lit {
  StrandSet strands = ofManyLengths();
  std::vector<float> t, v;
  Light lights[2] = {Light::parallel({1, -1, 0.3f}, {0.8f, 0.7f, 0.6f}),
                     Light::point({0.5f, 1.5f, 0.5f}, {0.2f, 3, 0.4f})};

  Lit() {
    for (std::uint32_t i = 0; i < 2 * strands.pointCount(); ++i)
      t.push_back(uniform(i, 7)), v.push_back(uniform(i, 8));
  }
  Illumination illumination() const { return {lights, glm::vec3(0), {0.3f, 3, 2}, t, v}; }
  std::vector<glm::vec3> radiance(const Appearance& appearance = {}) const {
    std::vector<glm::vec3> out(strands.pointCount());
    shade(strands, illumination(), appearance, out);
    return out;
  }
};

TEST(KajiyaKay, IsWhatThePlainFormulaSays) {
  const Lit lit;
  KajiyaKaySettings
      fractional;  // an exponent that is no whole number is another way through the kernel
  fractional.exponent = 20.5f;
  for (const KajiyaKaySettings& look :
       {KajiyaKaySettings(), KajiyaKaySettings::plain(), fractional}) {
    const std::vector<glm::vec3> fast = lit.radiance(look);
    std::vector<glm::vec3> exact(fast.size());
    literal::shade(lit.strands, lit.illumination(), look, exact);
    float brightest = 0;
    for (std::size_t p = 0; p < fast.size(); ++p)
      for (int c = 0; c < 3; ++c) {
        brightest = std::max(brightest, exact[p][c]);
        ASSERT_NEAR(fast[p][c], exact[p][c], 2e-5f * (1 + exact[p][c])) << p << ' ' << c;
      }
    EXPECT_GT(brightest, 1) << "nothing that bytes could not hold";
  }
}

TEST(KajiyaKay, IsLinearInTheLights) {
  const Lit lit;
  const std::size_t n = lit.strands.pointCount();
  const auto by = [&](std::span<const Light> lights, std::size_t first) {
    std::vector<glm::vec3> out(n);
    const std::span<const float> t(lit.t), v(lit.v);
    shade(lit.strands,
          {lights, glm::vec3(0), lit.illumination().eye, t.subspan(first * n, lights.size() * n),
           v.subspan(first * n, lights.size() * n)},
          {}, out);
    return out;
  };
  const std::span<const Light> all(lit.lights);
  const auto both = by(all, 0), first = by(all.first(1), 0), second = by(all.last(1), 1),
             none = by({}, 0);
  for (std::size_t p = 0; p < n; ++p)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(both[p][c], first[p][c] + second[p][c] - none[p][c], 1e-5f) << p;
}

TEST(KajiyaKay, HasTheSameBitsOnEveryInstructionSetAndForRanges) {
  const Lit lit;
  const std::size_t n = lit.strands.pointCount();
  std::vector<glm::vec3> best;
  std::vector<std::uint32_t> bestColours;
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    std::vector<glm::vec3> out(n);
    std::vector<std::uint32_t> colours(n);
    shade(lit.strands, lit.illumination(), {}, out, colours);
    if (best.empty()) best = out, bestColours = colours;
    EXPECT_EQ(out, best) << name;
    EXPECT_EQ(colours, bestColours) << name;
    std::fill(out.begin(), out.end(), glm::vec3(-1));
    std::fill(colours.begin(), colours.end(), 0u);
    for (std::size_t s = 0; s < 300; s += 25)
      shade(lit.strands, s, s + 25, lit.illumination(), {}, out, colours);
    EXPECT_EQ(out, best) << name << ", in ranges";
    EXPECT_EQ(colours, bestColours) << name << ", in ranges";
  }
}

TEST(Shade, MakesTheSameWhateverElseItMakes) {
  const Lit lit;
  const std::size_t n = lit.strands.pointCount();
  const std::vector<glm::vec3> alone = lit.radiance();
  std::vector<glm::vec3> radiance(n);
  std::vector<std::uint32_t> beside(n), bytesAlone(n), encoded(n);
  shade(lit.strands, lit.illumination(), {}, radiance, beside);
  shade(lit.strands, lit.illumination(), {}, {}, bytesAlone);
  encodeSrgb(alone, encoded);
  EXPECT_EQ(radiance, alone);
  EXPECT_EQ(beside, encoded);
  EXPECT_EQ(bytesAlone, encoded);
  shade(lit.strands, lit.illumination(), {}, {}, {});
}

TEST(Shade, RefusesWhatDoesNotFit) {
  const Lit lit;
  const std::size_t n = lit.strands.pointCount();
  std::vector<glm::vec3> radiance(n - 1);
  std::vector<std::uint32_t> colours(n + 1);
  EXPECT_THROW(shade(lit.strands, lit.illumination(), {}, radiance), Error);
  EXPECT_THROW(shade(lit.strands, lit.illumination(), {}, {}, colours), Error);
  EXPECT_THROW(shade(lit.strands, 0, 301, lit.illumination(), {}, {}), Error);
  radiance.resize(n);
  KajiyaKaySettings look;
  look.exponent = NAN;
  EXPECT_THROW(shade(lit.strands, lit.illumination(), look, radiance), Error);
  Illumination unseen = lit.illumination();
  unseen.eye.x = INFINITY;
  EXPECT_THROW(shade(lit.strands, unseen, {}, radiance), Error);
}

TEST(EncodeSrgb, IsTheTablesByteOfEveryChannelOnEveryInstructionSet) {
  // Not a whole number of blocks; with what is no colour among it.
  std::vector<glm::vec3> radiance;
  for (std::uint32_t i = 0; i < 5003; ++i)
    radiance.push_back(1.2f * glm::vec3(uniform(i, 1), uniform(i, 2), uniform(i, 3)) - 0.1f);
  radiance[17] = {NAN, INFINITY, -INFINITY};
  radiance[5002] = {1e30f, -1e30f, 1};
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    for (int threads : {1, 3}) {
      const ThreadLimit threadLimit(threads);
      std::vector<std::uint32_t> colours(radiance.size());
      encodeSrgb(radiance, colours);
      const SrgbTable& table = SrgbTable::get();
      for (std::size_t p = 0; p < radiance.size(); ++p) {
        ASSERT_EQ(red(colours[p]), table(radiance[p].x)) << name << ' ' << p;
        ASSERT_EQ(green(colours[p]), table(radiance[p].y)) << name << ' ' << p;
        ASSERT_EQ(blue(colours[p]), table(radiance[p].z)) << name << ' ' << p;
        ASSERT_EQ(colours[p] >> 24, 255u);
      }
    }
  }
  std::vector<std::uint32_t> few(5);
  EXPECT_THROW(encodeSrgb(radiance, few), Error);
}

TEST(EncodeSrgb, FadesStrandsByTheirWeights) {
  const std::vector<glm::vec3> radiance(9, glm::vec3(0.5f));
  const std::uint32_t first[] = {0, 4, 4, 7, 9};
  const float weights[] = {1, 0, 0.5f, 0};
  std::vector<std::uint32_t> opaque(9), faded(9);
  encodeSrgb(radiance, opaque);
  encodeSrgb(radiance, first, weights, faded);
  const std::uint32_t opacity[] = {255, 255, 255, 255, 128, 128, 128, 0, 0};
  for (std::size_t p = 0; p < 9; ++p) {
    EXPECT_EQ(faded[p] >> 24, opacity[p]);
    EXPECT_EQ(faded[p] & 0xffffffu, opaque[p] & 0xffffffu);
  }
  encodeSrgb(radiance, first, {}, faded);
  EXPECT_EQ(faded, opaque);
  EXPECT_THROW(fadeColours(std::span(first).first(3), weights, faded), Error);
  EXPECT_THROW(fadeColours(first, weights, std::span(faded).first(8)), Error);
}

TEST(KajiyaKay, DegenerateStrandsAreAmbient) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{1, 2, 3}});
  strands.append(std::vector<glm::vec3>{});
  strands.append(std::vector<glm::vec3>{{1, 2, 3}, {1, 2, 3}});
  for (std::uint32_t c : shadeAll(strands, {}, bare(0.25f, 1, 1))) EXPECT_EQ(red(c), byteOf(0.25f));
  EXPECT_TRUE(shadeAll(StrandSet{}, {}, {}).empty());
  EXPECT_THROW(shadeAll(strands, {}, {}, {1.0f}), Error);
}

}  // namespace
}  // namespace hair

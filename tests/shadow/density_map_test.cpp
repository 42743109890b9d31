#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>

#include "fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;
using test::kDeposits;
using test::kSlanted;
using test::oneStrand;
using test::shadow;
using test::total;

// Metres of optical depth that a fibre's metre is worth: its width times what makes the light that
// it leaves of a cell, 1 - opacity · width / cell, come out where it crosses one.
double coveredDepth(double width, double opacity, const DensityMapSettings& settings) {
  const auto cell = double{settings.cellSize};
  return -std::log(1 - opacity * width / cell) * cell;
}

TEST(OpticalDepth, IsConserved) {
  const StrandSet hair = headOfHair(300, 25);
  const Fibre fibre{80e-6f, 0.5f, 20.0f};
  for (Deposit d : {Deposit::Columns, Deposit::Segments})
    for (glm::vec3 direction : {kSlanted, glm::vec3(0, 1, 0)}) {
      DensityMapSettings settings;
      settings.deposit = d;
      const LightSpace light = makeLightSpace(direction);
      double expected = 0;
      for (std::size_t s = 0; s < hair.strandCount(); ++s)
        for (std::size_t p = 1; p < hair.strand(s).size(); ++p) {
          const glm::dvec3 e = glm::dvec3(hair.strand(s)[p]) - glm::dvec3(hair.strand(s)[p - 1]);
          expected += glm::length(glm::cross(e, glm::dvec3(light.direction()))) * 20 *
                      coveredDepth(80e-6, 0.5, settings) /
                      double{settings.cellSize * settings.cellSize};
        }
      DensityMap map;
      clear(map, settings, light);
      deposit(hair, fibre, map);
      EXPECT_NEAR(total(map.grid) / expected, 1, 1e-4);
      EXPECT_FALSE(map.aliased());
    }
}

TEST(OpticalDepth, OfDrawnHairIsThatOfItsShares) {
  const StrandSet hair = headOfHair(40, 25);
  const Fibre fibre{80e-6f, 0.5f, 20.0f};
  const std::vector<float> half(hair.strandCount(), 0.5f);
  DensityMap all, part;
  clear(all, {}, makeLightSpace(kSlanted));
  clear(part, {}, makeLightSpace(kSlanted));
  deposit(hair, fibre, all);
  deposit(DrawnHair{hair, fibre, half, 3}, part);
  EXPECT_NEAR(total(part.grid) / total(all.grid), 0.5, 1e-4);
  EXPECT_EQ(part.fibreShadow, 3 * all.fibreShadow);
}

TEST(OpticalDepth, OfHairLargerThanTheMapIsReportedAndHarmless) {
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 0.01f;
  DensityMap map;
  for (Deposit d : kDeposits) {
    settings.deposit = d;
    const auto t = shadow(oneStrand({{0, 0, 0}, {9e7f, -9e7f, 9e7f}, {0, 0, 1}}), settings,
                          makeLightSpace(kSlanted), map);
    EXPECT_TRUE(map.aliased());
    for (float v : t) EXPECT_TRUE(v >= 0 && v <= 1);
  }
}

TEST(Settings, FootprintChoosesTheCell) {
  const DensityMapSettings fine = settingsForFootprint(3e-3f, mapExtentNeeded(0.2f, 0.2f));
  EXPECT_FLOAT_EQ(fine.cellSize, 3e-3f);
  EXPECT_GE(fine.extent(), 0.6f);
  const DensityMapSettings coarse = settingsForFootprint(1e-4f, 0.6f, 128);
  EXPECT_EQ(coarse.cells, 128);
  EXPECT_GE(coarse.extent(), 0.6f * 0.99999f);
  EXPECT_THROW(settingsForFootprint(0, 1), Error);
}

TEST(Settings, OutOfRangeThrowAndNameTheKnob) {
  DensityMap map;
  const auto told = [&](const DensityMapSettings& settings) {
    try {
      clear(map, settings, alongX());
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  DensityMapSettings settings;
  EXPECT_EQ(told(settings), "");
  settings.cells = 5000;
  EXPECT_NE(told(settings).find("cells"), std::string::npos);
  settings = {};
  settings.filter = Filter::Footprint;
  settings.footprint = 11 * settings.cellSize;
  EXPECT_NE(told(settings).find("footprint"), std::string::npos);
  settings = {};
  settings.pointExtinction = -1;
  EXPECT_NE(told(settings).find("pointExtinction"), std::string::npos);
  DensityMap unready;
  EXPECT_THROW(deposit(headOfHair(2, 3), {}, unready), Error);
}

TEST(Settings, NothingDepositedIsAllLight) {
  DensityMap map;
  const auto t = shadow(StrandSet{}, {}, alongX(), map);
  computeTransmittance(map);
  const glm::vec3 p(0);
  float out = 0;
  sampleTransmittance(map, std::span(&p, 1), std::span(&out, 1));
  EXPECT_EQ(out, 1.0f);
  EXPECT_EQ(sampleDensity(map.grid, p).density, 0.0f);
}

}  // namespace
}  // namespace hair

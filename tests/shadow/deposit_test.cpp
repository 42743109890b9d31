#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

#include "fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;
using test::kDeposits;
using test::kFilters;
using test::kSlanted;
using test::oneHair;
using test::oneStrand;
using test::shadow;
using test::total;

TEST(Deposit, LosesNothingWhereAllThreadsMeetInOneCell) {
  StrandSet hair;
  for (int s = 0; s < 20000; ++s)
    hair.append(std::vector<glm::vec3>{{1e-3f, 1e-3f, 1e-3f},
                                       {2e-3f, 2e-3f, 1e-3f},
                                       {3e-3f, 1e-3f, 2e-3f},
                                       {1e-3f, 3e-3f, 1e-3f}});
  for (Deposit d : kDeposits) {
    DensityMapSettings settings;
    settings.deposit = d;
    double alone = 0;
    for (int threads : {1, 2, 7}) {
      const ThreadLimit limit(threads);
      DensityMap map;
      clear(map, settings, alongX());
      deposit(hair, oneHair(8e-5f, 0.6f), map);
      if (threads == 1) alone = total(map);
      EXPECT_EQ(total(map), alone) << threads << " threads";
    }
  }
}

// Metres of optical depth that a fibre's metre is worth: its width times what makes the light that
// it leaves of a cell, 1 - opacity · width / cell, come out where it crosses one.
double coveredDepth(double width, double opacity, const DensityMapSettings& settings) {
  const auto cell = double{settings.cellSize};
  return -std::log(1 - opacity * width / cell) * cell;
}

TEST(Deposit, ConservesOpticalDepthAndLength) {
  const StrandSet hair = headOfHair(300, 25);
  const Fibre fibre{80e-6f, 0.5f, 20.0f};
  for (Quantity quantity : {Quantity::OpticalDepth, Quantity::Length})
    for (Deposit d : {Deposit::Columns, Deposit::Segments})
      for (glm::vec3 direction : {kSlanted, glm::vec3(0, 1, 0)}) {
        DensityMapSettings settings;
        settings.deposit = d;
        settings.quantity = quantity;
        const LightSpace light = makeLightSpace(direction);
        double expected = 0;
        for (std::size_t s = 0; s < hair.strandCount(); ++s)
          for (std::size_t p = 1; p < hair.strand(s).size(); ++p) {
            const glm::dvec3 e = glm::dvec3(hair.strand(s)[p]) - glm::dvec3(hair.strand(s)[p - 1]);
            expected += quantity == Quantity::Length
                            ? 20.0 * glm::length(e)
                            : glm::length(glm::cross(e, glm::dvec3(light.direction()))) * 20 *
                                  coveredDepth(80e-6, 0.5, settings) /
                                  double{settings.cellSize * settings.cellSize};
          }
        DensityMap map;
        clear(map, settings, light);
        deposit(hair, fibre, map);
        EXPECT_NEAR(total(map) / expected, 1, 1e-4);
        EXPECT_FALSE(map.aliased());
      }
}

TEST(Deposit, SegmentsLeaveInEachCellWhatLiesInside) {
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 1.0f;
  settings.quantity = Quantity::Length;
  settings.deposit = Deposit::Segments;
  DensityMap map;
  clear(map, settings, alongX());
  // 0.5 in cell 0, 1 in cell 1, 0.25 in cell 2 along y; then back into cell 1 by 0.5.
  deposit(oneStrand({{0.5f, 0.5f, 0.5f}, {0.5f, 2.25f, 0.5f}, {0.5f, 1.5f, 0.5f}}), oneHair(1, 1),
          map);
  const auto at = [&](float y) { return map.density(map.cellOf({0.5f, y, 0.5f})); };
  EXPECT_NEAR(at(0.5f), 0.5f, 1e-5f);
  EXPECT_NEAR(at(1.5f), 1.5f, 1e-5f);
  EXPECT_NEAR(at(2.5f), 0.5f, 1e-5f);
  EXPECT_EQ(at(3.5f), 0.0f);
  EXPECT_EQ(at(-0.5f), 0.0f);
  // A diagonal: what sampling the segment finely finds.
  clear(map, settings, alongX());
  const glm::vec3 a(-2.3f, 0.4f, 7.1f), b(1.9f, -3.3f, 5.2f);
  deposit(oneStrand({a, b}), oneHair(1, 1), map);
  std::vector<float> expected(16 * 16 * 16);
  const auto index = [&](glm::ivec3 cell) {
    const glm::ivec3 c = map.wrap(cell);
    return static_cast<std::size_t>((c.x * 16 + c.y) * 16 + c.z);
  };
  for (int i = 0; i < 100000; ++i)
    expected[index(map.cellOf(glm::mix(a, b, (static_cast<float>(i) + 0.5f) / 1e5f)))] +=
        glm::distance(a, b) / 1e5f;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      for (int z = 0; z < 16; ++z) {
        const glm::ivec3 cell(x, y, z);
        ASSERT_NEAR(static_cast<float>(map.count(cell)) * map.quantum, expected[index(cell)],
                    2e-4f);
      }
}

TEST(Deposit, NegativeAndFarPointsFallIntoTheCellOfThePapersMapping) {
  for (double far : {0.0, 1e4, -3e7}) {
    DensityMapSettings settings;
    settings.cells = 10;
    settings.cellSize = 0.25f;
    settings.deposit = Deposit::Points;
    for (double x : {-0.01, 0.01, -1.3, 2.6, 77.1}) {
      DensityMap map;
      clear(map, settings, alongX(glm::dvec3(far, 0, -far)));
      deposit(oneStrand({{static_cast<float>(x), 0.1f, -0.1f}}), oneHair(1, 1), map);
      const auto psi = [](double v) {
        const auto cell = static_cast<long long>(std::floor(v / 0.25));
        return static_cast<int>((cell % 10 + 10) % 10);
      };
      EXPECT_EQ(map.bricks.count({psi(far + x), psi(0.1), psi(-far - 0.1)}), 1u) << far << " " << x;
    }
  }
}

TEST(Deposit, StrideCountsEveryStrandReadForThoseSkipped) {
  StrandSet hair;
  for (int s = 0; s < 40; ++s)
    hair.append(std::vector<glm::vec3>{{0.01f, 0.1f, 0.1f}, {0.05f, 0.18f, 0.12f}});
  for (Deposit d : kDeposits) {
    DensityMapSettings settings;
    settings.deposit = d;
    DensityMap all, few;
    clear(all, settings, makeLightSpace(kSlanted));
    deposit(hair, {}, all);
    clear(few, settings, makeLightSpace(kSlanted));
    deposit(hair, {}, few, 8);
    EXPECT_NEAR(total(few) / total(all), 1, 1e-4);
  }
}

TEST(Deposit, ReportsSaturationAndNeverWraps) {
  DensityMapSettings settings;
  settings.cells = 8;
  settings.cellSize = 1.0f;
  settings.quantity = Quantity::Length;
  settings.deposit = Deposit::Segments;
  StrandSet hair;
  // 2000 strands of 3 m in one cell, 6000 m: more than the 4096 that fit; a few elsewhere.
  for (int s = 0; s < 2000; ++s)
    hair.append(std::vector<glm::vec3>{{0.2f, 0.2f, 0.2f},
                                       {0.8f, 0.2f, 0.2f},
                                       {0.2f, 0.2f, 0.2f},
                                       {0.8f, 0.2f, 0.2f},
                                       {0.2f, 0.2f, 0.2f},
                                       {0.8f, 0.2f, 0.2f}});
  hair.append(std::vector<glm::vec3>{{3.2f, 0.2f, 0.2f}, {3.7f, 0.2f, 0.2f}});
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    DensityMap map;
    for (int round = 0; round < 2; ++round) {
      clear(map, settings, alongX());
      deposit(hair, oneHair(1, 1), map);
      EXPECT_EQ(map.saturatedCells, 1u);
      EXPECT_EQ(map.density(map.cellOf({0.5f, 0.2f, 0.2f})), 4096.0f);
      EXPECT_NEAR(map.density(map.cellOf({3.5f, 0.2f, 0.2f})), 0.5f, 1e-5f);
    }
    // One addition that alone is too large.
    clear(map, settings, alongX());
    deposit(oneStrand({{0.2f, 0.2f, 0.2f}, {0.8f, 0.2f, 0.2f}}), {1, 1, 1e9f}, map);
    EXPECT_EQ(map.saturatedCells, 1u);
    // And the next frame knows nothing of it.
    clear(map, settings, alongX());
    deposit(oneStrand({{0.2f, 0.2f, 0.2f}, {0.8f, 0.2f, 0.2f}}), oneHair(1, 1), map);
    EXPECT_EQ(map.saturatedCells, 0u);
    EXPECT_NEAR(total(map), 0.6, 1e-5);
  }
}

TEST(Deposit, HairLargerThanTheMapIsReported) {
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 0.01f;
  DensityMap map;
  clear(map, settings, alongX());
  deposit(oneStrand({{0, 0, 0}, {0, 0.1f, 0}}), {}, map);
  EXPECT_FALSE(map.aliased());
  deposit(oneStrand({{0, 0, 0}, {0, 0.2f, 0}}), {}, map);
  EXPECT_TRUE(map.aliased());
  // Absurd sizes end, and nothing is written outside.
  for (Deposit d : kDeposits) {
    settings.deposit = d;
    const auto t = shadow(oneStrand({{0, 0, 0}, {9e7f, -9e7f, 9e7f}, {0, 0, 1}}), settings,
                          makeLightSpace(kSlanted), map);
    EXPECT_TRUE(map.aliased());
    for (float v : t) EXPECT_TRUE(v >= 0 && v <= 1);
  }
}

TEST(Filter, OfAConstantFieldIsConstant) {
  // A wall of equal depth everywhere across the light; behind it all points are equally dark.
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 1.0f;
  settings.footprint = 3.5f;
  StrandSet wall;
  for (int j = 0; j < 16; ++j)
    wall.append(std::vector<glm::vec3>{{0.5f, static_cast<float>(j) + 0.5f, 0.0f},
                                       {0.5f, static_cast<float>(j) + 0.5f, 15.9999f}});
  for (Filter f : kFilters) {
    settings.filter = f;
    DensityMap map;
    clear(map, settings, alongX());
    deposit(wall, oneHair(1.0f, 0.7f), map);
    computeTransmittance(map);
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 500; ++i)
      points.push_back({2 + 10 * uniform(i, 0), 4 + 8 * uniform(i, 1), 4 + 8 * uniform(i, 2)});
    std::vector<float> t(points.size());
    sampleTransmittance(map, points, t);
    // Fibres as wide as a cell, side by side: each takes its opacity, not exp(-opacity).
    for (float v : t) ASSERT_NEAR(v, 0.3f, 1e-6f);
  }
}

TEST(Filter, CentredPeaksInTheMiddleOfACellAndPaperAtItsFarCorner) {
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 1.0f;
  DensityMap map;
  const auto darkestAt = [&](Filter f, int axis) {
    settings.filter = f;
    clear(map, settings, alongX());
    deposit(oneStrand({{0.5f, 5.2f, 5.5f}, {0.5f, 5.8f, 5.5f}}), oneHair(1, 1), map);
    computeTransmittance(map);
    float darkest = 2, where = 0;
    for (int i = 0; i < 400; ++i) {
      const float other = f == Filter::Paper ? 5.999f : 5.5f,
                  here = 4 + 0.01f * static_cast<float>(i);
      const glm::vec3 p = axis == 1 ? glm::vec3(3, here, other) : glm::vec3(3, other, here);
      float t;
      sampleTransmittance(map, std::span(&p, 1), std::span(&t, 1));
      if (t < darkest) darkest = t, where = here;
    }
    return where;
  };
  for (int axis : {1, 2}) {
    EXPECT_NEAR(darkestAt(Filter::Centred, axis), 5.5f, 0.02f);
    EXPECT_NEAR(darkestAt(Filter::Paper, axis), 6.0f, 0.02f);
  }
}

TEST(Density, IntegratesToTheLengthOfHair) {
  const StrandSet hair = headOfHair(200, 25);
  DensityMapSettings settings;
  settings.cells = 32;
  settings.cellSize = 0.02f;
  settings.quantity = Quantity::Length;
  double length = 0;
  for (std::size_t s = 0; s < hair.strandCount(); ++s) length += double{arcLength(hair.strand(s))};
  for (Deposit d : kDeposits) {
    settings.deposit = d;
    DensityMap map;
    clear(map, settings, makeLightSpace(kSlanted));
    deposit(hair, {80e-6f, 0.6f, 30.0f}, map);
    double sum = 0;
    for (int i = map.lower.x; i <= map.upper.x; ++i)
      for (int j = map.lower.y; j <= map.upper.y; ++j)
        for (int k = map.lower.z; k <= map.upper.z; ++k) sum += double{map.density({i, j, k})};
    const double volume = std::pow(double{settings.cellSize}, 3);
    // Points count one more a strand than there are segments.
    EXPECT_NEAR(sum * volume / (30 * length), 1, d == Deposit::Points ? 0.05 : 1e-4);
  }
}

TEST(Density, SampleMeetsCellCentresAndItsGradientItsDifferences) {
  const StrandSet hair = headOfHair(500, 25, 0.25f, {-5, 40, 9});
  DensityMapSettings settings;
  settings.cells = 32;
  settings.cellSize = 0.02f;
  settings.quantity = Quantity::Length;
  DensityMap map;
  clear(map, settings, makeLightSpace(kSlanted));
  deposit(hair, {}, map);
  for (std::size_t p = 0; p < hair.pointCount(); p += 53) {
    const glm::ivec3 cell = map.cellOf(hair.points[p]);
    EXPECT_GT(map.density(cell), 0);
    const glm::vec3 centre = map.cellCentre(cell);
    EXPECT_LT(glm::distance(centre, hair.points[p]), 0.02f * 0.8661f);
    EXPECT_NEAR(sampleDensity(map, centre).density / map.density(cell), 1, 2e-2);
    // Inside one cell of the interpolation the gradient's slope is the function's.
    const glm::vec3 inside =
        centre + 0.004f * glm::transpose(map.light.lightFromWorld) * glm::vec3(1, 1, 1);
    const glm::vec3 gradient = sampleDensity(map, inside).gradient;
    const float h = 1e-3f, scale = map.density(cell) / 0.02f;
    for (int c = 0; c < 3; ++c) {
      glm::vec3 e(0);
      e[c] = h;
      const float slope =
          (sampleDensity(map, inside + e).density - sampleDensity(map, inside - e).density) /
          (2 * h);
      EXPECT_NEAR(gradient[c] / scale, slope / scale, 0.05);
    }
  }
  EXPECT_EQ(sampleDensity(map, glm::vec3(0)).density, 0.0f);
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
  DensityMapSettings settings;
  settings.cells = 5000;
  try {
    clear(map, settings, alongX());
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("cells"), std::string::npos);
  }
  EXPECT_THROW(makeLightSpace(glm::vec3(0)), Error);
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
  EXPECT_EQ(sampleDensity(map, p).density, 0.0f);
}

}  // namespace
}  // namespace hair

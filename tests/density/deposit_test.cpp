#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_access.hpp>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

#include "fixture.h"

namespace hair {
namespace {

using test::about;
using test::along;
using test::headOfHair;
using test::kDeposits;
using test::kSlanted;
using test::oneStrand;
using test::total;

TEST(Deposit, LosesNothingWhereAllThreadsMeetInOneCell) {
  StrandSet hair;
  for (int s = 0; s < 20000; ++s)
    hair.append(std::vector<glm::vec3>{{1e-3f, 1e-3f, 1e-3f},
                                       {2e-3f, 2e-3f, 1e-3f},
                                       {3e-3f, 1e-3f, 2e-3f},
                                       {1e-3f, 3e-3f, 1e-3f}});
  for (Deposit d : kDeposits) {
    DensityGridSettings settings;
    settings.deposit = d;
    double alone = 0;
    for (int threads : {1, 2, 7}) {
      const ThreadLimit limit(threads);
      DensityGrid grid;
      clear(grid, settings);
      deposit(hair, metresOfHair(), grid);
      if (threads == 1) alone = total(grid);
      EXPECT_EQ(total(grid), alone) << threads << " threads";
    }
  }
}

TEST(Deposit, ConservesWhatIsMeasured) {
  const StrandSet hair = headOfHair(300, 25);
  using enum SegmentMeasure::Of;
  for (SegmentMeasure::Of of : {Length, AcrossX})
    for (Deposit d : {Deposit::Columns, Deposit::Segments})
      for (const GridSpace& space :
           {along(kSlanted), along({0, 1, 0}), about({0.3f, 0.8f, 0.1f})}) {
        // In a curved grid a thing looks larger from the focus than its length.
        if (of == AcrossX && space.curvature > 0) continue;
        DensityGridSettings settings;
        settings.deposit = d;
        const glm::dvec3 x = glm::row(glm::dmat3(space.gridFromWorld), 0);
        double expected = 0;
        for (std::size_t s = 0; s < hair.strandCount(); ++s)
          for (std::size_t p = 1; p < hair.strand(s).size(); ++p) {
            const glm::dvec3 e = glm::dvec3(hair.strand(s)[p]) - glm::dvec3(hair.strand(s)[p - 1]);
            expected += 20 * glm::length(of == Length ? e : glm::cross(e, x));
          }
        DensityGrid grid;
        clear(grid, settings, space);
        deposit(hair, {of, 20}, grid);
        EXPECT_NEAR(total(grid) / expected, 1, space.curvature > 0 ? 2e-3 : 1e-4);
        EXPECT_FALSE(grid.aliased());
      }
}

TEST(Deposit, PointsAreWorthTheMeanSegmentUnlessTold) {
  const StrandSet hair = headOfHair(200, 25);
  DensityGridSettings settings;
  settings.deposit = Deposit::Points;
  double length = 0;
  for (std::size_t s = 0; s < hair.strandCount(); ++s) length += double{arcLength(hair.strand(s))};
  EXPECT_NEAR(metresPerPoint(hair), length / static_cast<double>(hair.pointCount()), 1e-5);
  DensityGrid grid;
  const auto worth = [&](const SegmentMeasure& measure) {
    clear(grid, settings);
    deposit(hair, measure, grid);
    return double{grid.quantum};
  };
  const double mean = double{metresPerPoint(hair)};
  EXPECT_NEAR(worth(metresOfHair(30)), 30 * mean, 1e-6);
  EXPECT_NEAR(worth({SegmentMeasure::Of::AcrossX, 30}), 30 * mean * std::acos(-1) / 4, 1e-6);
  EXPECT_EQ(worth({SegmentMeasure::Of::AcrossX, 30, 0.25f}), 0.25);
}

TEST(Deposit, SegmentsLeaveInEachCellWhatLiesInside) {
  DensityGridSettings settings;
  settings.cells = 16;
  settings.cellSize = 1.0f;
  settings.deposit = Deposit::Segments;
  DensityGrid grid;
  clear(grid, settings);
  // 0.5 in cell 0, 1 in cell 1, 0.25 in cell 2 along y; then back into cell 1 by 0.5.
  deposit(oneStrand({{0.5f, 0.5f, 0.5f}, {0.5f, 2.25f, 0.5f}, {0.5f, 1.5f, 0.5f}}), metresOfHair(),
          grid);
  const auto at = [&](float y) { return grid.density(grid.cellOf({0.5f, y, 0.5f})); };
  EXPECT_NEAR(at(0.5f), 0.5f, 1e-5f);
  EXPECT_NEAR(at(1.5f), 1.5f, 1e-5f);
  EXPECT_NEAR(at(2.5f), 0.5f, 1e-5f);
  EXPECT_EQ(at(3.5f), 0.0f);
  EXPECT_EQ(at(-0.5f), 0.0f);
  // A diagonal: what sampling the segment finely finds.
  clear(grid, settings);
  const glm::vec3 a(-2.3f, 0.4f, 7.1f), b(1.9f, -3.3f, 5.2f);
  deposit(oneStrand({a, b}), metresOfHair(), grid);
  std::vector<float> expected(16 * 16 * 16);
  const auto index = [&](glm::ivec3 cell) {
    const glm::ivec3 c = grid.wrap(cell);
    return static_cast<std::size_t>((c.x * 16 + c.y) * 16 + c.z);
  };
  for (int i = 0; i < 100000; ++i)
    expected[index(grid.cellOf(glm::mix(a, b, (static_cast<float>(i) + 0.5f) / 1e5f)))] +=
        glm::distance(a, b) / 1e5f;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      for (int z = 0; z < 16; ++z) {
        const glm::ivec3 cell(x, y, z);
        ASSERT_NEAR(static_cast<float>(grid.count(cell)) * grid.quantum, expected[index(cell)],
                    2e-4f);
      }
}

TEST(Deposit, NegativeAndFarPointsFallIntoTheCellOfThePapersMapping) {
  for (double far : {0.0, 1e4, -3e7}) {
    DensityGridSettings settings;
    settings.cells = 10;
    settings.cellSize = 0.25f;
    settings.deposit = Deposit::Points;
    for (double x : {-0.01, 0.01, -1.3, 2.6, 77.1}) {
      DensityGrid grid;
      clear(grid, settings, {glm::mat3(1), glm::dvec3(far, 0, -far)});
      deposit(oneStrand({{static_cast<float>(x), 0.1f, -0.1f}}), {SegmentMeasure::Of::Length, 1, 1},
              grid);
      const auto psi = [](double v) {
        const auto cell = static_cast<long long>(std::floor(v / 0.25));
        return static_cast<int>((cell % 10 + 10) % 10);
      };
      EXPECT_EQ(grid.cells->bricks.count({psi(far + x), psi(0.1), psi(-far - 0.1)}), 1u)
          << far << " " << x;
    }
  }
}

TEST(Deposit, StrideCountsEveryStrandReadForThoseSkipped) {
  StrandSet hair;
  for (int s = 0; s < 40; ++s)
    hair.append(std::vector<glm::vec3>{{0.01f, 0.1f, 0.1f}, {0.05f, 0.18f, 0.12f}});
  for (Deposit d : kDeposits) {
    DensityGridSettings settings;
    settings.deposit = d;
    DensityGrid all, few;
    clear(all, settings, along(kSlanted));
    deposit(hair, metresOfHair(), all);
    clear(few, settings, along(kSlanted));
    deposit(hair, metresOfHair(), few, 8);
    EXPECT_NEAR(total(few) / total(all), 1, 1e-4);
  }
}

TEST(Deposit, ReportsSaturationAndNeverWraps) {
  DensityGridSettings settings;
  settings.cells = 8;
  settings.cellSize = 1.0f;
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
    DensityGrid grid;
    for (int round = 0; round < 2; ++round) {
      clear(grid, settings);
      deposit(hair, metresOfHair(), grid);
      EXPECT_EQ(grid.saturatedCells, 1u);
      EXPECT_EQ(grid.density(grid.cellOf({0.5f, 0.2f, 0.2f})), 4096.0f);
      EXPECT_NEAR(grid.density(grid.cellOf({3.5f, 0.2f, 0.2f})), 0.5f, 1e-5f);
    }
    // One addition that alone is too large.
    clear(grid, settings);
    deposit(oneStrand({{0.2f, 0.2f, 0.2f}, {0.8f, 0.2f, 0.2f}}), metresOfHair(1e9f), grid);
    EXPECT_EQ(grid.saturatedCells, 1u);
    // And the next frame knows nothing of it.
    clear(grid, settings);
    deposit(oneStrand({{0.2f, 0.2f, 0.2f}, {0.8f, 0.2f, 0.2f}}), metresOfHair(), grid);
    EXPECT_EQ(grid.saturatedCells, 0u);
    EXPECT_NEAR(total(grid), 0.6, 1e-5);
  }
}

TEST(Deposit, HairLargerThanTheGridIsReported) {
  DensityGridSettings settings;
  settings.cells = 16;
  settings.cellSize = 0.01f;
  DensityGrid grid;
  clear(grid, settings);
  deposit(oneStrand({{0, 0, 0}, {0, 0.1f, 0}}), {}, grid);
  EXPECT_FALSE(grid.aliased());
  deposit(oneStrand({{0, 0, 0}, {0, 0.2f, 0}}), {}, grid);
  EXPECT_TRUE(grid.aliased());
  // Absurd sizes end, and nothing is written outside.
  for (Deposit d : kDeposits) {
    settings.deposit = d;
    clear(grid, settings, along(kSlanted));
    deposit(oneStrand({{0, 0, 0}, {9e7f, -9e7f, 9e7f}, {0, 0, 1}}), {}, grid);
    EXPECT_TRUE(grid.aliased());
  }
}

TEST(Density, IntegratesToTheLengthOfHair) {
  const StrandSet hair = headOfHair(200, 25);
  DensityGridSettings settings;
  settings.cells = 32;
  settings.cellSize = 0.02f;
  double length = 0;
  for (std::size_t s = 0; s < hair.strandCount(); ++s) length += double{arcLength(hair.strand(s))};
  for (Deposit d : kDeposits) {
    settings.deposit = d;
    DensityGrid grid;
    clear(grid, settings, along(kSlanted));
    deposit(hair, metresOfHair(30), grid);
    double sum = 0;
    for (int i = grid.lower.x; i <= grid.upper.x; ++i)
      for (int j = grid.lower.y; j <= grid.upper.y; ++j)
        for (int k = grid.lower.z; k <= grid.upper.z; ++k) sum += double{grid.density({i, j, k})};
    const double volume = std::pow(double{settings.cellSize}, 3);
    // Points count one more a strand than there are segments.
    EXPECT_NEAR(sum * volume / (30 * length), 1, d == Deposit::Points ? 0.05 : 1e-4);
  }
}

TEST(Density, SampleMeetsCellCentresAndItsGradientItsDifferences) {
  const StrandSet hair = headOfHair(500, 25, 0.25f, {-5, 40, 9});
  DensityGridSettings settings;
  settings.cells = 32;
  settings.cellSize = 0.02f;
  DensityGrid grid;
  clear(grid, settings, along(kSlanted));
  deposit(hair, {}, grid);
  for (std::size_t p = 0; p < hair.pointCount(); p += 53) {
    const glm::ivec3 cell = grid.cellOf(hair.points[p]);
    EXPECT_GT(grid.density(cell), 0);
    const glm::vec3 centre = grid.cellCentre(cell);
    EXPECT_LT(glm::distance(centre, hair.points[p]), 0.02f * 0.8661f);
    EXPECT_NEAR(sampleDensity(grid, centre).density / grid.density(cell), 1, 2e-2);
    // Inside one cell of the interpolation the gradient's slope is the function's.
    const glm::vec3 inside =
        centre + 0.004f * glm::transpose(grid.space.gridFromWorld) * glm::vec3(1, 1, 1);
    const glm::vec3 gradient = sampleDensity(grid, inside).gradient;
    const float h = 1e-3f, scale = grid.density(cell) / 0.02f;
    for (int c = 0; c < 3; ++c) {
      glm::vec3 e(0);
      e[c] = h;
      const float slope =
          (sampleDensity(grid, inside + e).density - sampleDensity(grid, inside - e).density) /
          (2 * h);
      EXPECT_NEAR(gradient[c] / scale, slope / scale, 0.05);
    }
  }
  EXPECT_EQ(sampleDensity(grid, glm::vec3(0)).density, 0.0f);
}

TEST(Deposit, ArgumentsOutOfRangeThrowAndNameTheKnob) {
  DensityGrid grid;
  EXPECT_THROW(deposit(headOfHair(2, 3), {}, grid), Error);
  DensityGridSettings settings;
  settings.cells = 5000;
  try {
    clear(grid, settings);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("cells"), std::string::npos);
  }
  clear(grid, {});
  const StrandSet hair = headOfHair(2, 3);
  EXPECT_THROW(deposit(hair, {}, grid, 0), Error);
  EXPECT_THROW(deposit(hair, metresOfHair(-1), grid), Error);
  EXPECT_THROW(deposit(hair, metresOfHair(NAN), grid), Error);
  EXPECT_THROW(deposit(hair, {}, grid, 1, std::vector<float>{1}), Error);
  EXPECT_TRUE(grid.empty());
  EXPECT_EQ(sampleDensity(grid, glm::vec3(0)).density, 0.0f);
}

}  // namespace
}  // namespace hair

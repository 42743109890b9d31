#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/density/segment_walk.h>

#include "fixture.h"

namespace hair {
namespace {

using test::about;
using test::along;
using test::headOfHair;
using test::hostileHair;
using test::kDeposits;
using test::kSlanted;

/// Counts of wrapped cells, without the zeros.
using Counts = std::map<std::array<int, 3>, std::uint32_t>;

Counts countsOf(const DensityGrid& grid) {
  Counts counts;
  const int n = grid.settings.cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        if (const std::uint32_t c = grid.cells->bricks.count({x, y, z})) counts[{x, y, z}] = c;
  return counts;
}

/// What the walks of segment_walk.h write to.
struct PlainWriter {
  const DensityGrid& grid;
  Counts counts;
  void add(glm::ivec3 cell, std::uint32_t count) {
    if (count == 0) return;
    const glm::ivec3 c = grid.wrap(cell);
    std::uint32_t& sum = counts[{c.x, c.y, c.z}];
    sum = addSaturating(sum, count);
  }
};

/// One point after the other, of a grid that the same was deposited in.
Counts oneByOne(StrandView strands, const SegmentMeasure& measure, const DensityGrid& grid,
                std::uint32_t stride) {
  const DensityGridSettings& settings = grid.settings;
  const auto perCell =
      static_cast<float>(measure.perMetre * static_cast<double>(settings.cellSize));
  const SegmentScale scale{measure.of, perCell * static_cast<float>(stride) / kQuantum,
                           grid.cells->frame};
  PlainWriter writer{grid, {}};
  for (std::size_t s = 0; s < strands.strandCount(); s += stride) {
    const auto points = strands.strand(s);
    Rounder rounder;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const glm::vec3 b = grid.cells->frame.cellCoordinates(points[p]);
      if (settings.deposit == Deposit::Points) {
        writer.add(floorToCell(b), stride);
      } else if (p > 0) {
        const glm::vec3 a = grid.cells->frame.cellCoordinates(points[p - 1]);
        depositColumns(a, b, rounder.take(scale.amount(a, b)), static_cast<float>(settings.cells),
                       writer);
      }
    }
  }
  return writer.counts;
}

struct Case {
  StrandSet strands;
  GridSpace space;
  SegmentMeasure measure{SegmentMeasure::Of::AcrossX, 50};
};

std::vector<Case> cases() {
  using enum SegmentMeasure::Of;
  const StrandSet head = headOfHair(300, 33);
  return {{head, along(kSlanted)},
          {head, along({0, 1, 0})},
          {head, about({0.4f, 0.6f, -0.2f})},
          {head, along(kSlanted), metresOfHair(20)},
          {head, about({0.4f, 0.6f, -0.2f}), metresOfHair(20)},
          // So little that counts are few, and so much that a segment is more than a lane holds.
          {head, along(kSlanted), {AcrossX, 1e-5}},
          {head, along(kSlanted), {AcrossX, 1e6}},
          {head, along(kSlanted), {AcrossX, 1e8}},
          {hostileHair(1), along(kSlanted)},
          {hostileHair(2), {glm::mat3(1), {1e4, -3e7, 0.5}}},
          {hostileHair(3), about({0.03f, 0.05f, -0.02f})}};
}

TEST(DepositKernels, CountAsOnePointAfterTheOther) {
  const std::vector<Case> all = cases();
  for (const Case& c : all)
    for (Deposit d : {Deposit::Points, Deposit::Columns})
      for (int cells : {64, 50})
        for (std::uint32_t stride : {1u, 3u}) {
          DensityGridSettings settings;
          settings.cells = cells;
          settings.deposit = d;
          DensityGrid grid;
          clear(grid, settings, c.space);
          deposit(c.strands, c.measure, grid, stride);
          ASSERT_EQ(countsOf(grid), oneByOne(c.strands, c.measure, grid, stride))
              << cells << " cells, stride " << stride << ", case " << &c - all.data();
        }
}

TEST(DepositKernels, CountsDependOnNeitherThreadsNorInstructionSets) {
  std::vector<Case> all = cases();
  // Enough for several threads.
  all.push_back({headOfHair(4000, 25), along(kSlanted)});
  for (const Case& c : all)
    for (Deposit d : kDeposits) {
      DensityGridSettings settings;
      settings.cells = 48;
      settings.deposit = d;
      Counts expected;
      glm::ivec3 lower(0), upper(0);
      std::uint32_t saturated = 0;
      float quantum = 0;
      bool first = true;
      for (const std::string_view name : instructionSets())
        for (int threads : {1, 2, 7}) {
          const InstructionSetLimit set(name);
          const ThreadLimit limit(threads);
          DensityGrid grid;
          clear(grid, settings, c.space);
          deposit(c.strands, c.measure, grid);
          deposit(c.strands, c.measure, grid, 5);
          if (first) {
            expected = countsOf(grid), lower = grid.lower, upper = grid.upper;
            saturated = grid.saturatedCells, quantum = grid.quantum;
          }
          first = false;
          ASSERT_EQ(countsOf(grid), expected) << name << ", " << threads << " threads";
          ASSERT_EQ(grid.lower, lower);
          ASSERT_EQ(grid.upper, upper);
          ASSERT_EQ(grid.saturatedCells, saturated);
          ASSERT_EQ(grid.quantum, quantum);
        }
    }
}

TEST(DepositKernels, ReportWhatDoesNotFit) {
  // 2600 strands of 1.6 m in one cell are 4160 m, 64 more than it holds; 2500 are 4000.
  DensityGridSettings settings;
  settings.cells = 16;
  settings.cellSize = 1;
  StrandSet hair;
  for (int s = 0; s < 12600; ++s) {
    const float z = s < 2600 ? 0.5f : 3.5f + static_cast<float>(s % 4);
    hair.append(std::vector<glm::vec3>{{0.5f, 0.1f, z}, {0.5f, 0.9f, z}, {0.5f, 0.1f, z}});
  }
  const auto depositFirst = [&](std::size_t strands, DensityGrid& grid) {
    clear(grid, settings);
    deposit(StrandView{std::span(hair.points).first(3 * strands),
                       std::span(hair.first).first(strands + 1)},
            metresOfHair(), grid);
    return grid.density(grid.cellOf({0.5f, 0.5f, 0.5f}));
  };
  for (const std::string_view name : instructionSets())
    for (int threads : {1, 2, 7}) {
      const InstructionSetLimit set(name);
      const ThreadLimit limit(threads);
      DensityGrid grid;
      EXPECT_EQ(depositFirst(12600, grid), 4096.0f);
      EXPECT_EQ(grid.saturatedCells, 1u);
      EXPECT_NEAR(depositFirst(2500, grid), 4000.0f, 1e-2f);
      EXPECT_EQ(grid.saturatedCells, 0u);
    }
}

TEST(Rounder, KeepsTheSumOfAStrand) {
  for (float each : {0.001f, 0.3f, 0.7f, 1.0f, 1234.567f, 8e6f}) {
    Rounder rounder;
    double counts = 0, amounts = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const float amount = each * uniform(i, 0);
      counts += rounder.take(amount);
      amounts += double{amount};
    }
    EXPECT_NEAR(counts, amounts, 0.5 + 1000 * 0x1p-17) << each;
  }
}

}  // namespace
}  // namespace hair

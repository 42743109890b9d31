#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/density/extinction.h>
#include <libhair/density/segment_walk.h>

#include "fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;
using test::kDeposits;
using test::kFilters;
using test::kSlanted;
using test::oneHair;
using test::shadow;

/// Counts of wrapped cells, without the zeros.
using Counts = std::map<std::array<int, 3>, std::uint32_t>;

Counts countsOf(const DensityMap& map) {
  Counts counts;
  const int n = map.settings.cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        if (const std::uint32_t c = map.bricks.count({x, y, z})) counts[{x, y, z}] = c;
  return counts;
}

/// What the walks of segment_walk.h write to.
struct PlainWriter {
  const DensityMap& map;
  Counts counts;
  void add(glm::ivec3 cell, std::uint32_t count) {
    if (count == 0) return;
    const glm::ivec3 c = map.wrap(cell);
    std::uint32_t& sum = counts[{c.x, c.y, c.z}];
    sum = addSaturating(sum, count);
  }
};

/// One point after the other, of a map that the same was deposited in.
Counts oneByOne(StrandView strands, const Fibre& fibre, const DensityMap& map,
                std::uint32_t stride) {
  const DensityMapSettings& settings = map.settings;
  const bool length = settings.quantity == Quantity::Length;
  const float ds = settings.cellSize;
  const float perStrand = length
                              ? fibre.hairsPerStrand * ds
                              : fibre.width * fibre.hairsPerStrand * extinctionOf(fibre, ds) / ds;
  const SegmentScale scale{perStrand * static_cast<float>(stride) / kQuantum, !length, map.frame};
  PlainWriter writer{map, {}};
  for (std::size_t s = 0; s < strands.strandCount(); s += stride) {
    const auto points = strands.strand(s);
    Rounder rounder;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const glm::vec3 b = map.frame.cellCoordinates(points[p]);
      if (settings.deposit == Deposit::Points) {
        writer.add(floorToCell(b), stride);
      } else if (p > 0) {
        const glm::vec3 a = map.frame.cellCoordinates(points[p - 1]);
        depositColumns(a, b, rounder.take(scale.amount(a, b)), static_cast<float>(settings.cells),
                       writer);
      }
    }
  }
  return writer.counts;
}

/// All that goes wrong: strands without points, of one, of many equal ones, segments of no length
/// and far longer than any map, points at the walls of cells, and coordinates where floats are
/// coarser than cells.
StrandSet hostileHair(std::uint32_t seed) {
  StrandSet strands;
  std::vector<glm::vec3> points;
  const auto random = [&](std::uint32_t a, std::uint32_t b) { return uniform(seed * 1000 + a, b); };
  for (std::uint32_t s = 0; s < 200; ++s) {
    points.clear();
    const std::uint32_t size = static_cast<std::uint32_t>(random(s, 0) * 40);
    const float scale = random(s, 1) < 0.1f ? 1e7f : random(s, 1) < 0.2f ? 30.0f : 0.1f;
    for (std::uint32_t p = 0; p < size; ++p) {
      glm::vec3 to(random(s, 3 * p + 2), random(s, 3 * p + 3), random(s, 3 * p + 4));
      to = scale * (2.0f * to - 1.0f);
      const float kind = random(s, 200 + p);
      if (kind < 0.1f && p > 0) to = points.back();
      if (kind > 0.8f) to = glm::round(to / 0.0075f) * 0.0075f;
      if (kind > 0.9f && p > 0) to.y = points.back().y;
      points.push_back(to);
    }
    strands.append(points);
  }
  return strands;
}

struct Case {
  StrandSet strands;
  LightSpace light;
  Fibre fibre{};
  Quantity quantity = Quantity::OpticalDepth;
};

std::vector<Case> cases() {
  const StrandSet head = headOfHair(300, 33);
  return {{head, makeLightSpace(kSlanted)},
          {head, makeLightSpace({0, 1, 0})},
          {head, makePointLightSpace({0.4f, 0.6f, -0.2f}, glm::vec3(0))},
          {head, makeLightSpace(kSlanted), {80e-6f, 0.5f, 20.0f}, Quantity::Length},
          // So thin that counts are few, and so thick that a segment is more than a lane holds.
          {head, makeLightSpace(kSlanted), {1e-9f, 0.5f, 1.0f}},
          {head, makeLightSpace(kSlanted), {80e-6f, 0.5f, 1e6f}},
          {head, makeLightSpace(kSlanted), {80e-6f, 0.5f, 1e8f}},
          {hostileHair(1), makeLightSpace(kSlanted)},
          {hostileHair(2), alongX({1e4, -3e7, 0.5})},
          {hostileHair(3), makePointLightSpace({0.03f, 0.05f, -0.02f}, glm::vec3(0))}};
}

TEST(DepositKernels, CountAsOnePointAfterTheOther) {
  const std::vector<Case> all = cases();
  for (const Case& c : all)
    for (Deposit d : {Deposit::Points, Deposit::Columns})
      for (int cells : {64, 50})
        for (std::uint32_t stride : {1u, 3u}) {
          DensityMapSettings settings;
          settings.cells = cells;
          settings.deposit = d;
          settings.quantity = c.quantity;
          DensityMap map;
          clear(map, settings, c.light);
          deposit(c.strands, c.fibre, map, stride);
          ASSERT_EQ(countsOf(map), oneByOne(c.strands, c.fibre, map, stride))
              << cells << " cells, stride " << stride << ", case " << &c - all.data();
        }
}

TEST(DepositKernels, CountsDependOnNeitherThreadsNorInstructionSets) {
  std::vector<Case> all = cases();
  // Enough for several threads.
  all.push_back({headOfHair(4000, 25), makeLightSpace(kSlanted)});
  for (const Case& c : all)
    for (Deposit d : kDeposits) {
      DensityMapSettings settings;
      settings.cells = 48;
      settings.deposit = d;
      settings.quantity = c.quantity;
      Counts expected;
      std::vector<float> light;
      glm::ivec3 lower(0), upper(0);
      std::uint32_t saturated = 0;
      float quantum = 0;
      bool first = true;
      for (const std::string_view name : instructionSets())
        for (int threads : {1, 2, 7}) {
          const InstructionSetLimit set(name);
          const ThreadLimit limit(threads);
          DensityMap map;
          clear(map, settings, c.light);
          deposit(c.strands, c.fibre, map);
          deposit(c.strands, c.fibre, map, 5);
          std::vector<float> t(c.strands.pointCount());
          computeTransmittance(map);
          sampleTransmittance(map, c.strands.points, t);
          if (first) {
            expected = countsOf(map), light = t, lower = map.lower, upper = map.upper;
            saturated = map.saturatedCells, quantum = map.quantum;
          }
          first = false;
          ASSERT_EQ(countsOf(map), expected) << name << ", " << threads << " threads";
          ASSERT_EQ(t, light) << name << ", " << threads << " threads";
          ASSERT_EQ(map.lower, lower);
          ASSERT_EQ(map.upper, upper);
          ASSERT_EQ(map.saturatedCells, saturated);
          ASSERT_EQ(map.quantum, quantum);
        }
    }
}

TEST(DepositKernels, ReportWhatDoesNotFit) {
  // 2600 strands of 1.6 m in one cell are 4160 m, 64 more than it holds; 2500 are 4000.
  DensityMapSettings settings;
  settings.cells = 16;
  settings.cellSize = 1;
  settings.quantity = Quantity::Length;
  StrandSet hair;
  for (int s = 0; s < 12600; ++s) {
    const float z = s < 2600 ? 0.5f : 3.5f + static_cast<float>(s % 4);
    hair.append(std::vector<glm::vec3>{{0.5f, 0.1f, z}, {0.5f, 0.9f, z}, {0.5f, 0.1f, z}});
  }
  const auto depositFirst = [&](std::size_t strands, DensityMap& map) {
    clear(map, settings, alongX());
    deposit(StrandView{std::span(hair.points).first(3 * strands),
                       std::span(hair.first).first(strands + 1)},
            oneHair(1, 1), map);
    return map.density(map.cellOf({0.5f, 0.5f, 0.5f}));
  };
  for (const std::string_view name : instructionSets())
    for (int threads : {1, 2, 7}) {
      const InstructionSetLimit set(name);
      const ThreadLimit limit(threads);
      DensityMap map;
      EXPECT_EQ(depositFirst(12600, map), 4096.0f);
      EXPECT_EQ(map.saturatedCells, 1u);
      EXPECT_NEAR(depositFirst(2500, map), 4000.0f, 1e-2f);
      EXPECT_EQ(map.saturatedCells, 0u);
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

TEST(Transmittance, IsReadOnlyWhereItWasWritten) {
  // Codes that were not written are of a frame before: filled with the darkest, nothing changes.
  const StrandSet hair = headOfHair(400, 20);
  for (glm::vec3 direction : {kSlanted, glm::vec3(0, -1, 0), glm::vec3(1, 0.1f, -0.3f)})
    for (Filter f : kFilters) {
      DensityMapSettings settings;
      settings.filter = f;
      settings.footprint = 10 * settings.cellSize;
      DensityMap map;
      std::vector<glm::vec3> points = hair.points;
      for (std::uint32_t i = 0; i < 5000; ++i)
        points.push_back(0.6f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.3f);
      shadow(hair, settings, makeLightSpace(direction), map);
      std::vector<float> clean(points.size()), stale(points.size());
      sampleTransmittance(map, points, clean);
      std::fill(map.lightIn.begin(), map.lightIn.end(),
                4u * static_cast<std::uint32_t>(map.bricks.size()) | Transmittances::kFixed);
      computeTransmittance(map);
      sampleTransmittance(map, points, stale);
      EXPECT_EQ(clean, stale);
    }
}

}  // namespace
}  // namespace hair

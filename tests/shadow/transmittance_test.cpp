#include <optional>

#include <gtest/gtest.h>

#include <libhair/core/approximate.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/density/grid_cells.h>
#include <libhair/shadow/literal.h>
#include <libhair/shadow/transmittances.h>

#include "fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;
using test::kDeposits;
using test::kFilters;
using test::kSlanted;
using test::largestDifference;
using test::oneHair;
using test::shadow;
using test::total;

DensityMapSettings paperSettings() {
  DensityMapSettings settings;
  settings.deposit = Deposit::Points;
  settings.filter = Filter::Paper;
  settings.pointExtinction = 60;
  return settings;
}

std::vector<float> literalShadow(StrandView strands, const DensityMapSettings& settings,
                                 const LightSpace& light) {
  literal::LiteralMap map;
  map.cells = settings.cells;
  map.cellSize = settings.cellSize;
  map.extinction = settings.pointExtinction;
  std::vector<float> out(strands.pointCount());
  literal::fillDensity(strands.points, light, map);
  literal::computeTransmittance(map);
  literal::filterTransmittance(map, strands.points, out);
  return out;
}

TEST(Approximations, StayWithinTheirStatedErrors) {
  double worst = 0;
  for (int i = 0; i <= 200000; ++i) {
    const float x = static_cast<float>(i) * 69.0f / 200000;
    worst = std::max(worst, std::abs(expMinusApproximate(x) * std::exp(double{x}) - 1));
  }
  EXPECT_LT(worst, 3e-7);
  EXPECT_EQ(expMinusApproximate(0), 1.0f);
  EXPECT_GE(expMinusApproximate(1e30f), 0.0f);
}

TEST(Transmittance, EqualsTheLiteralReference) {
  const StrandSet hair = headOfHair(400, 31);
  DensityMap map;
  for (int cells : {128, 96, 64, 130, 50, 33}) {
    for (glm::vec3 direction : {kSlanted, glm::vec3(-1, 0.2f, 0.4f), glm::vec3(0, 0, -1)}) {
      DensityMapSettings settings = paperSettings();
      settings.cells = cells;
      settings.cellSize = 0.7f / static_cast<float>(cells);
      const LightSpace light = makeLightSpace(direction, {3, -1, 2});
      const auto fast = shadow(hair, settings, light, map);
      const auto slow = literalShadow(hair, settings, light);
      EXPECT_LT(largestDifference(fast, slow), 1e-5f) << cells;
      const auto [least, most] = std::minmax_element(slow.begin(), slow.end());
      EXPECT_LT(*least, 0.2f) << "the scene has no shadow to compare";
      EXPECT_GT(*most, 0.8f);
    }
  }
}

TEST(Transmittance, LiesBetweenDarkAndLight) {
  const StrandSet hair = headOfHair(2000, 20);
  DensityMap map;
  for (Deposit d : kDeposits)
    for (Filter f : kFilters) {
      DensityMapSettings settings;
      settings.deposit = d;
      settings.filter = f;
      for (float t : shadow(hair, settings, makeLightSpace(kSlanted), map)) {
        ASSERT_GE(t, 0.0f);
        ASSERT_LE(t, 1.0f);
      }
    }
}

TEST(Transmittance, NeverIncreasesAlongTheLight) {
  const StrandSet hair = headOfHair(1000, 20);
  const LightSpace light = makeLightSpace(kSlanted);
  DensityMap map;
  for (Deposit d : kDeposits)
    for (Filter f : kFilters) {
      DensityMapSettings settings;
      settings.deposit = d;
      settings.filter = f;
      shadow(hair, settings, light, map);
      bool shadowed = false;
      for (std::uint32_t ray = 0; ray < 200; ++ray) {
        const glm::vec3 through = hair.points[ray * 97 % hair.pointCount()];
        std::vector<glm::vec3> points;
        for (int i = -300; i <= 300; ++i)
          points.push_back(through + 2e-3f * static_cast<float>(i) * light.direction());
        std::vector<float> t(points.size());
        sampleTransmittance(map, points, t);
        EXPECT_EQ(t.front(), 1.0f);
        // Lateral weights differ in their last bits from point to point of a slanted ray.
        for (std::size_t i = 1; i < t.size(); ++i) ASSERT_LE(t[i], t[i - 1] + 2e-5f);
        shadowed |= t.back() < 0.5f;
      }
      EXPECT_TRUE(shadowed);
    }
}

TEST(Transmittance, IsOneInFrontOfAllHairAndBesideItWhereverTheSeamIs) {
  const DensityMapSettings base;
  DensityMap map;
  // The wrapped slice of the first hair takes every value as the hair moves through a whole map.
  for (int shift = 0; shift < base.cells; shift += 3) {
    const glm::vec3 centre = static_cast<float>(shift) * base.cellSize * glm::vec3(1, 1, 1);
    const StrandSet hair = headOfHair(60, 10, 0.25f, centre);
    const Bounds box = bounds(hair.points);
    for (int i = 0; i < 8; ++i) {
      const Filter f = kFilters[i % 4];
      DensityMapSettings settings = base;
      settings.filter = f;
      settings.deposit = i < 4 ? Deposit::Columns : Deposit::Segments;
      shadow(hair, settings, alongX(), map);
      std::vector<glm::vec3> lit;
      for (std::uint32_t p = 0; p < 300; ++p) {
        const glm::vec3 u(uniform(p, 0), uniform(p, 1), uniform(p, 2));
        const glm::vec3 inside = box.lower + u * box.size();
        lit.push_back({box.lower.x - base.cellSize * (2 + 200 * u.x), inside.y, inside.z});
        lit.push_back({inside.x + 0.3f, box.upper.y + base.cellSize * (2 + 200 * u.y), inside.z});
        lit.push_back({inside.x + 0.3f, inside.y, box.lower.z - base.cellSize * (2 + 200 * u.z)});
      }
      std::vector<float> t(lit.size());
      sampleTransmittance(map, lit, t);
      for (float v : t) ASSERT_EQ(v, 1.0f) << "shift " << shift;
      if (settings.deposit == Deposit::Columns) continue;  // shares with the slice in front
      // The point of the hair nearest to the light stands in the first slice, at its front.
      const auto nearest = *std::min_element(hair.points.begin(), hair.points.end(),
                                             [](auto a, auto b) { return a.x < b.x; });
      const glm::vec3 justInFront =
          map.grid.cellCentre(map.grid.cellOf(nearest)) - glm::vec3(0.5001f * base.cellSize, 0, 0);
      float front = 0;
      sampleTransmittance(map, std::span(&justInFront, 1), std::span(&front, 1));
      EXPECT_EQ(front, 1.0f);
    }
  }
}

TEST(Transmittance, BehindTheHairIsThatOfTheLastSlice) {
  const StrandSet hair = headOfHair(500, 20);
  const Bounds box = bounds(hair.points);
  DensityMap map;
  shadow(hair, {}, alongX(), map);
  const glm::vec3 c = box.centre();
  const glm::vec3 behind[] = {{box.upper.x + 0.01f, c.y, c.z}, {box.upper.x + 30.0f, c.y, c.z}};
  float t[2];
  sampleTransmittance(map, behind, t);
  EXPECT_EQ(t[0], t[1]);
  EXPECT_LT(t[0], 0.5f);
}

TEST(Transmittance, MovesWithTheHairByWholeCells) {
  const StrandSet hair = headOfHair(500, 20);
  DensityMap map;
  for (Deposit d : kDeposits)
    for (glm::vec3 direction : {kSlanted, glm::vec3(1, 0, 0)}) {
      DensityMapSettings settings;
      settings.deposit = d;
      const LightSpace here = makeLightSpace(direction);
      const auto at = shadow(hair, settings, here, map);
      // About 10 km away, by whole cells of the light's own grid.
      const double ds = double{settings.cellSize};
      const glm::dvec3 cells(-1333333, 700001, 99991);
      LightSpace there = here;
      there.origin = glm::inverse(glm::dmat3(here.lightFromWorld)) * (cells * ds);
      EXPECT_GT(glm::length(there.origin), 1e4);
      const auto far = shadow(hair, settings, there, map);
      // A point counts whole or not at all where rounding takes it over a wall.
      EXPECT_LT(largestDifference(at, far), d == Deposit::Points ? 0.02f : 2e-4f);
      // A few cells by float coordinates.
      StrandSet moved = hair;
      const glm::vec3 few =
          glm::transpose(here.lightFromWorld) * (settings.cellSize * glm::vec3(5, -200, 77));
      for (glm::vec3& p : moved.points) p += few;
      const auto near = shadow(moved, settings, here, map);
      EXPECT_LT(largestDifference(at, near), d == Deposit::Points ? 0.05f : 1e-3f);
    }
}

TEST(Transmittance, OfFarFloatPointsIsThatOfTheirOwnPositions) {
  // At 4 km floats are 0.24 mm apart. Snap the hair to that grid: then moving it is exact.
  const auto snap = [](glm::vec3 p) { return glm::round(p * 4096.0f) / 4096.0f; };
  StrandSet hair = headOfHair(500, 20);
  for (glm::vec3& p : hair.points) p = snap(p);
  StrandSet far = hair;
  const glm::vec3 offset(-2048, 1024, 2048);
  for (glm::vec3& p : far.points) p += offset;
  DensityMap map;
  const LightSpace light = makeLightSpace(kSlanted);
  const LightSpace same = makeLightSpace(kSlanted, glm::dvec3(offset));
  const auto a = shadow(hair, {}, same, map), b = shadow(far, {}, light, map);
  EXPECT_LT(largestDifference(a, b), 1e-4f);
}

TEST(Transmittance, TurnsWithHairAndLightTogether) {
  // The frame across the light is free: turn about the light so that the grid turns along.
  const StrandSet hair = headOfHair(500, 20);
  const glm::quat turn = glm::angleAxis(1.1f, glm::normalize(glm::vec3(1, 2, -1)));
  StrandSet turned = hair;
  for (glm::vec3& p : turned.points) p = turn * p;
  const LightSpace light = makeLightSpace(kSlanted);
  LightSpace turnedLight;
  turnedLight.lightFromWorld = light.lightFromWorld * glm::mat3_cast(glm::conjugate(turn));
  DensityMap map;
  const auto a = shadow(hair, {}, light, map), b = shadow(turned, {}, turnedLight, map);
  EXPECT_LT(largestDifference(a, b), 1e-3f);
}

TEST(Transmittance, HasTheSameBitsForAnyThreadCountAndInstructionSet) {
  const StrandSet all[] = {headOfHair(3000, 20), test::hostileHair(1), test::hostileHair(2)};
  for (const StrandSet& hair : all)
    for (Deposit d : kDeposits) {
      std::optional<std::uint64_t> first;
      for (const std::string_view name : instructionSets())
        for (int threads : {1, 2, 7}) {
          const InstructionSetLimit set(name);
          const ThreadLimit limit(threads);
          DensityMapSettings settings;
          settings.deposit = d;
          DensityMap map;
          const auto t = shadow(hair, settings, makeLightSpace(kSlanted), map);
          StateHash hash;
          hash.add(std::span<const float>(t));
          if (!first) first = hash.value();
          EXPECT_EQ(hash.value(), first) << name << ", " << threads << " threads";
        }
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
      std::fill(map.bricks->lightIn.begin(), map.bricks->lightIn.end(),
                4u * static_cast<std::uint32_t>(map.grid.brickCount()) | Transmittances::kFixed);
      computeTransmittance(map);
      sampleTransmittance(map, points, stale);
      EXPECT_EQ(clean, stale);
    }
}

TEST(Transmittance, OfAUsedMapIsThatOfANewOne) {
  const StrandSet hair = headOfHair(500, 20), other = headOfHair(300, 30, 0.3f, {0.1f, 0.2f, 0});
  DensityMap used, fresh;
  shadow(other, {}, makeLightSpace({1, 0.1f, 0}), used);
  const auto a = shadow(hair, {}, makeLightSpace(kSlanted), used);
  const auto b = shadow(hair, {}, makeLightSpace(kSlanted), fresh);
  EXPECT_EQ(a, b);
  EXPECT_EQ(total(used.grid), total(fresh.grid));
}

TEST(Transmittance, OfASlabOfRandomFibresIsUnbiased) {
  // n fibres of length l at angle theta over an area A: the mean light that passes is
  // exp(-alpha · w · l · sin(theta) · n / A), whatever the cell.
  const float width = 1e-4f, opacity = 0.6f, length = 0.02f, theta = 0.9f;
  const int cells = 32;
  const float ds = 5e-3f, side = cells * ds;
  const std::uint32_t n = 30000;
  StrandSet fibres;
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::vec3 p = side * glm::vec3(0.3f * uniform(i, 0), uniform(i, 1), uniform(i, 2));
    const float turn = 6.2831853f * uniform(i, 3);
    const glm::vec3 d(std::cos(theta), std::sin(theta) * std::cos(turn),
                      std::sin(theta) * std::sin(turn));
    fibres.append(std::vector<glm::vec3>{p, p + 0.4f * length * d, p + length * d});
  }
  const double expected =
      std::exp(-double{opacity} * width * length * std::sin(theta) * n / (double{side} * side));
  for (Deposit d : kDeposits) {
    DensityMapSettings settings;
    settings.cells = cells;
    settings.cellSize = ds;
    settings.deposit = d;
    // Fibres leave the slab sideways; the modulo brings them back in, which is what a slab without
    // end would do. With points there are three a fibre, with two segments each.
    settings.pointExtinction = opacity * width * length * std::sin(theta) / 3.0f / (ds * ds) / ds;
    DensityMap map;
    clear(map, settings, alongX());
    deposit(fibres, oneHair(width, opacity), map);
    computeTransmittance(map);
    map.settings.filter = Filter::None;
    std::vector<glm::vec3> behind;
    for (int k = 0; k < cells; ++k)
      for (int j = 0; j < cells; ++j)
        behind.push_back(map.grid.cellCentre(
            {map.grid.lower.x + map.grid.depth(), map.grid.lower.y + j, map.grid.lower.z + k}));
    std::vector<float> t(behind.size());
    sampleTransmittance(map, behind, t);
    double mean = 0;
    for (float v : t) mean += static_cast<double>(v) / static_cast<double>(t.size());
    EXPECT_NEAR(mean, expected, 0.01) << static_cast<int>(d);
    EXPECT_LT(expected, 0.5);
  }
}

}  // namespace
}  // namespace hair

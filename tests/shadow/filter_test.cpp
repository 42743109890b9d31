#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/literal.h>

#include "fixture.h"

namespace hair {
namespace {

// Points of the hair, around it, and far off.
std::vector<glm::vec3> pointsAround(const StrandSet& hair) {
  std::vector<glm::vec3> points;
  for (std::uint32_t p = 0; p < 600; ++p) {
    const glm::vec3 onHair = hair.points[(p * 37) % hair.points.size()];
    const glm::vec3 any(uniform(p, 1), uniform(p, 2), uniform(p, 3));
    points.push_back(onHair);
    points.push_back(onHair + 0.05f * (any - 0.5f));
    points.push_back(2.0f * (any - 0.5f));
  }
  return points;
}

void expectLiteral(const StrandSet& hair, const DensityMapSettings& settings,
                   const LightSpace& light) {
  const auto points = pointsAround(hair);
  std::vector<float> t(points.size());
  DensityMap map;
  test::shadow(hair, settings, light, map, {1e-3f, 0.6f, 1});
  ASSERT_FALSE(map.aliased());
  sampleTransmittance(map, points, t);
  for (std::size_t p = 0; p < points.size(); ++p)
    ASSERT_NEAR(t[p], literal::transmittance(map, points[p]), 4e-6)
        << settings.cells << " cells, filter " << static_cast<int>(settings.filter) << ", point "
        << p;
}

TEST(Filter, WeightsWhatLeavesTheEightCellsAroundAPoint) {
  const StrandSet hair = test::headOfHair(150, 24);
  // 100 and 70 cells end in the middle of a brick.
  for (const auto& [cells, size] : {std::pair{128, 7.5e-3f}, {100, 8e-3f}, {70, 10e-3f}})
    for (const Filter filter : {Filter::None, Filter::Paper, Filter::Centred})
      for (const glm::vec3 origin : {glm::vec3(0), glm::vec3(0.31f, 0.4f, -0.27f)}) {
        DensityMapSettings settings;
        settings.cells = cells, settings.cellSize = size, settings.filter = filter;
        LightSpace light = makeLightSpace(test::kSlanted);
        light.origin = origin;  // moves the seam through the hair
        expectLiteral(hair, settings, light);
      }
}

TEST(Filter, WeightsTheCellsOfAFootprint) {
  const StrandSet hair = test::headOfHair(150, 24);
  for (const float cellsWide : {0.5f, 2.0f, 5.0f})
    for (const int cells : {128, 100}) {
      DensityMapSettings settings;
      settings.cells = cells, settings.cellSize = 1.0f / static_cast<float>(cells);
      settings.filter = Filter::Footprint, settings.footprint = cellsWide * settings.cellSize;
      LightSpace light = makeLightSpace(test::kSlanted);
      light.origin = glm::vec3(0.31f, 0.4f, -0.27f);  // moves the seam through the hair
      expectLiteral(hair, settings, light);
    }
}

TEST(Filter, DoesSoInHairThatFillsItsMapWhereverTheSeamIs) {
  // A block of 19 cells in a map of 20: the walk ends in the brick in which it began.
  StrandSet block;
  for (std::uint32_t s = 0; s < 400; ++s) {
    const glm::vec3 a(uniform(s, 1), uniform(s, 2), uniform(s, 3));
    const glm::vec3 b(uniform(s, 4), uniform(s, 5), uniform(s, 6));
    block.append(std::vector<glm::vec3>{0.18f * a, 0.18f * glm::mix(a, b, 0.2f)});
  }
  DensityMapSettings settings;
  settings.cells = 20, settings.cellSize = 0.01f;
  for (const Filter filter : {Filter::None, Filter::Paper, Filter::Centred})
    for (int seam = 0; seam < 20; ++seam) {
      settings.filter = filter;
      const double at = 0.01 * seam;
      expectLiteral(block, settings, test::alongX(glm::dvec3(at, -at, 0.5 * at)));
    }
}

TEST(Filter, HasTheSameBitsOnEveryInstructionSetAndInAnyParts) {
  const StrandSet hair = test::headOfHair(300, 24);
  const auto points = pointsAround(hair);
  for (const Filter filter : test::kFilters)
    for (const bool atPoint : {false, true}) {
      DensityMapSettings settings;
      settings.filter = filter, settings.footprint = 2 * settings.cellSize;
      DensityMap map;
      test::shadow(hair, settings,
                   atPoint ? makePointLightSpace({0.3f, 1, 0.2f}, glm::vec3(0))
                           : makeLightSpace(test::kSlanted),
                   map);
      std::vector<float> whole(points.size()), again(points.size());
      sampleTransmittance(map, points, whole);
      const auto expectSame = [&](std::string_view how) {
        EXPECT_EQ(std::memcmp(whole.data(), again.data(), whole.size() * sizeof(float)), 0) << how;
      };
      for (const std::string_view name : instructionSets()) {
        const InstructionSetLimit limit(name);
        computeTransmittance(map);
        sampleTransmittance(map, points, again);
        expectSame(name);
      }
      const ThreadLimit three(3);
      sampleTransmittance(map, points, again);
      expectSame("threads");
      const TransmittanceSampler sampler(map, TransmittanceSampler::Of::Points);
      for (std::size_t p = 0, n; p < points.size(); p += n) {
        n = std::min(points.size() - p, 1 + p % 77);
        sampler.sample(std::span(points).subspan(p, n), std::span(again).subspan(p, n));
      }
      expectSame("parts");
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
  for (Filter f : test::kFilters) {
    settings.filter = f;
    DensityMap map;
    clear(map, settings, test::alongX());
    deposit(wall, test::oneHair(1.0f, 0.7f), map);
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
    clear(map, settings, test::alongX());
    deposit(test::oneStrand({{0.5f, 5.2f, 5.5f}, {0.5f, 5.8f, 5.5f}}), test::oneHair(1, 1), map);
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

TEST(Filter, OfAMapThatIsNotReadyIsRefused) {
  const StrandSet hair = test::headOfHair(3, 4);
  std::vector<float> t(hair.pointCount());
  DensityMap map;
  clear(map, {}, makeLightSpace(test::kSlanted));
  deposit(hair, {}, map);
  EXPECT_THROW(sampleTransmittance(map, hair.points, t), Error);
  computeTransmittance(map);
  EXPECT_NO_THROW(sampleTransmittance(map, hair.points, t));
  t.pop_back();
  EXPECT_THROW(sampleTransmittance(map, hair.points, t), Error);
}

}  // namespace
}  // namespace hair

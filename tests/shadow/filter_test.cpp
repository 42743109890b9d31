#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>

#include "fixture.h"

namespace hair {
namespace {

// Equation 3 as it stands: what leaves an unwrapped cell towards the back. From the counts alone,
// so that neither bricks nor runs nor codes are in it.
double leaving(const DensityMap& map, glm::ivec3 cell) {
  double depth = 0;
  const bool beside =
      cell.y < map.lower.y || cell.y > map.upper.y || cell.z < map.lower.z || cell.z > map.upper.z;
  for (int i = map.lower.x; !beside && i <= std::min(cell.x, map.upper.x); ++i)
    depth += static_cast<double>(map.quantum) * map.count({i, cell.y, cell.z});
  return std::exp(-depth);
}

// The filters of section 3.3, one point at a time: weights of the eight cells around it.
double filtered(const DensityMap& map, glm::vec3 p) {
  const glm::dvec3 shift(0, 1, 1);
  const glm::vec3 u = map.frame.cellCoordinates(p);
  if (map.settings.filter == Filter::None) return leaving(map, glm::ivec3(glm::floor(u)));
  const glm::dvec3 v = glm::dvec3(u) - (map.settings.filter == Filter::Paper ? 1.0 : 0.5) * shift;
  const glm::ivec3 c(glm::floor(v));
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 d(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 t = v - glm::dvec3(c), w = glm::mix(1.0 - t, t, glm::dvec3(d));
    sum += w.x * w.y * w.z * leaving(map, c + d - glm::ivec3(1, 0, 0));
  }
  return sum;
}

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

void expectWeightsOfEightCells(const StrandSet& hair, const DensityMapSettings& settings,
                               const LightSpace& light) {
  const auto points = pointsAround(hair);
  std::vector<float> t(points.size());
  DensityMap map;
  test::shadow(hair, settings, light, map, {1e-3f, 0.6f, 1});
  ASSERT_FALSE(map.aliased());
  sampleTransmittance(map, points, t);
  for (std::size_t p = 0; p < points.size(); ++p)
    ASSERT_NEAR(t[p], filtered(map, points[p]), 4e-6)
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
        expectWeightsOfEightCells(hair, settings, light);
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
      expectWeightsOfEightCells(block, settings, test::alongX(glm::dvec3(at, -at, 0.5 * at)));
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

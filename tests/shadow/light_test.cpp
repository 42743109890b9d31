#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/shadow/density_map.h>

#include "fixture.h"

namespace hair {
namespace {

using test::headOfHair;
using test::kSlanted;
using test::largestDifference;
using test::oneHair;

TEST(PointLight, FarAwayIsParallelLight) {
  const StrandSet hair = headOfHair(1500, 25);
  const glm::vec3 way = glm::normalize(kSlanted);
  for (Filter f : {Filter::Centred, Filter::Footprint}) {
    DensityMapSettings settings;
    settings.filter = f;
    settings.footprint = 15e-3f;
    // The pivot in the middle of the cell that the parallel light's map anchors at the first point.
    LightSpace parallel = makeLightSpace(way);
    const glm::vec3 anchor = hair.points.front();
    const CellFrame frame = makeCellFrame(parallel, anchor, settings.cellSize, settings.cells);
    const glm::vec3 pivot = frame.point(glm::vec3(0));
    DensityMap a, b;
    const Fibre fibre{80e-6f, 0.6f, 60};
    const auto expected = test::shadow(hair, settings, parallel, a, fibre);
    for (float distance : {1e4f, 1e6f, 1e9f}) {
      const LightSpace point = makePointLightSpace(pivot - distance * way, pivot);
      EXPECT_LT(largestDifference(test::shadow(hair, settings, point, b, fibre), expected), 1e-3f)
          << distance << " m";
    }
    float least = 1;
    for (float t : expected) least = std::min(least, t);
    EXPECT_LT(least, 0.1f);
  }
}

TEST(PointLight, OpticalDepthIsWhatAFibreCoversAsSeenFromTheLight) {
  // A short fibre across the ray at distance r covers l w of the sphere of radius r; a cell there
  // has the area (ds / magnification)².
  const LightSpace light = makePointLightSpace({0, 0.4f, 0}, {0, 0, 0});
  DensityMapSettings settings;
  for (float y : {-0.2f, -0.05f, 0.1f, 0.2f})
    for (float x : {0.0f, 0.1f}) {
      DensityMap map;
      clear(map, settings, light);
      const glm::vec3 p(x, y, 0.02f), way = light.directionAt(p);
      const glm::vec3 step = 5e-4f * glm::normalize(glm::cross(way, glm::vec3(1, 0.3f, 0)));
      deposit(test::oneStrand({p - step, p + step}), oneHair(80e-6f, 0.5f), map);
      const float r = glm::distance(p, light.position());
      const float cosine = glm::dot(way, light.direction());
      // Solid angle that a pixel of 1 x 1 stereographic units of size ds / D has there.
      const float pixel = settings.cellSize / 0.4f * (1 + cosine) / 2;
      const float expected = 1e-3f * 80e-6f * 0.5f / (r * r * pixel * pixel);
      EXPECT_NEAR(test::total(map.grid) / static_cast<double>(expected), 1, 0.01) << x << " " << y;
    }
}

TEST(PointLight, InTheHairIsReportedAndHarmless) {
  const StrandSet hair = headOfHair(300, 20);
  DensityMap map;
  // At a strand's very point, at the head's middle, and behind itself.
  for (glm::vec3 at : {hair.points[17], glm::vec3(0, 0.001f, 0), glm::vec3(0, 0.12f, 0)}) {
    const auto t = test::shadow(hair, {}, makePointLightSpace(at, {0, 0, 0}), map);
    for (float v : t) {
      ASSERT_GE(v, 0.0f);
      ASSERT_LE(v, 1.0f);
    }
  }
  // Hair all around: no map of small cells is large enough, and it says so.
  DensityMapSettings fine;
  fine.cellSize = 1e-3f;
  test::shadow(hair, fine, makePointLightSpace({0, 0.05f, 0}, {0, 0, 0}), map);
  EXPECT_TRUE(map.aliased());
}

TEST(Footprint, FilterIsTheMeanOverADiscOfTheVariance) {
  // One opaque column of cells: the filter spreads it as a disc of the footprint would.
  for (float radius : {2.0f, 3.5f, 6.0f, 9.0f}) {
    DensityMapSettings settings;
    settings.cells = 64;
    settings.cellSize = 1.0f;
    settings.filter = Filter::Footprint;
    settings.footprint = radius;
    DensityMap map;
    clear(map, settings, test::alongX());
    deposit(test::oneStrand({{0.5f, 0.0f, 0.5f}, {0.5f, 0.999f, 0.5f}}), oneHair(1, 1), map);
    computeTransmittance(map);
    std::vector<glm::vec3> points;
    for (int y = -240; y < 240; ++y)
      for (int z = -240; z < 240; ++z)
        points.push_back(
            {5, 0.5f + 0.0625f * static_cast<float>(y), 0.5f + 0.0625f * static_cast<float>(z)});
    std::vector<float> t(points.size());
    sampleTransmittance(map, points, t);
    double sum = 0, second = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double dark = 1 - static_cast<double>(t[p]), y = static_cast<double>(points[p].y) - 0.5;
      sum += dark;
      second += dark * y * y;
    }
    const double darkness = 1 - 1e-4;  // of the cell: opacity 1 is taken for 1 - 1e-4
    EXPECT_NEAR(sum * 0.0625 * 0.0625 / darkness, 1, 1e-3) << radius;
    // The cell itself, a box of variance 1/12, is what was smeared already.
    EXPECT_NEAR(second / sum, static_cast<double>(radius * radius) / 4 - 1.0 / 12, 0.02) << radius;
  }
}

TEST(Footprint, OfAConstantFieldAcrossTheSeamIsConstant) {
  // Hair that fills the map to its last cell but for the margin, wherever the map's seam falls.
  DensityMapSettings settings;
  settings.cells = 24;
  settings.cellSize = 1.0f;
  settings.filter = Filter::Footprint;
  settings.footprint = 4;
  for (float shift : {0.0f, 5.0f, 11.0f, 19.0f}) {
    StrandSet wall;
    for (int j = 0; j < 24; ++j)
      wall.append(
          std::vector<glm::vec3>{{0.5f, shift + static_cast<float>(j) + 0.5f, shift},
                                 {0.5f, shift + static_cast<float>(j) + 0.5f, shift + 23.9999f}});
    DensityMap map;
    clear(map, settings, test::alongX());
    deposit(wall, oneHair(1.0f, 0.7f), map);
    computeTransmittance(map);
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 300; ++i)
      points.push_back({4, shift + 5 + 14 * uniform(i, 1), shift + 5 + 14 * uniform(i, 2)});
    std::vector<float> t(points.size());
    sampleTransmittance(map, points, t);
    for (float v : t) ASSERT_NEAR(v, 0.3f, 1e-6f) << shift;
  }
}

TEST(OwnShadow, OfALoneStrandIsTakenOffOnAverage) {
  // Straight strands far from each other: nothing shadows them but themselves.
  StrandSet hair;
  for (std::uint32_t s = 0; s < 100; ++s) {
    const glm::vec3 root(static_cast<float>(s / 10) * 0.1f + 0.02f * uniform(s, 1),
                         0.01f * uniform(s, 2),
                         static_cast<float>(s % 10) * 0.1f + 0.02f * uniform(s, 3));
    const glm::vec3 d =
        glm::normalize(glm::vec3(uniform(s, 4), uniform(s, 5), uniform(s, 6)) - 0.5f);
    std::vector<glm::vec3> points;
    for (int k = 0; k < 30; ++k) points.push_back(root + 1e-3f * static_cast<float>(k) * d);
    hair.append(points);
  }
  const LightSpace light = makeLightSpace({0, -1, 0});
  const Fibre fibre = oneHair(0.3e-3f, 0.6f);
  for (float footprint : {1e-3f, 3e-3f, 6e-3f}) {
    DensityMapSettings settings = automaticMapSettings(hair, light, footprint);
    settings.cells = std::min(settings.cells, 400);
    settings.cellSize = std::max(settings.cellSize, footprint / 2);
    DensityMap map;
    clear(map, settings, light);
    deposit(hair, fibre, map);
    computeTransmittance(map);
    std::vector<float> with(hair.pointCount()), without(hair.pointCount());
    sampleTransmittance(map, hair.points, with);
    sampleStrandTransmittance(map, hair, without);
    // The middle of each strand, where both of its ways lead out of the filter.
    double shadowed = 0, freed = 0;
    for (std::size_t s = 0; s < 100; ++s) {
      shadowed += 1 - static_cast<double>(with[hair.first[s] + 15]);
      freed += 1 - static_cast<double>(without[hair.first[s] + 15]);
    }
    EXPECT_GT(shadowed / 100, 0.4 * 0.3e-3 * 0.6 / static_cast<double>(2 * footprint));
    // Clamped to full light one by one, so what noise there is remains.
    EXPECT_LT(freed, 0.25 * shadowed) << footprint;
  }
}

TEST(Automatic, SettingsHoldTheHairAndMatchTheFootprint) {
  const StrandSet hair = headOfHair(500, 20);
  for (float footprint : {1e-3f, 3e-3f, 6e-3f, 0.05f}) {
    const LightSpace light = makeLightSpace(kSlanted);
    const DensityMapSettings settings = automaticMapSettings(hair, light, footprint);
    EXPECT_FLOAT_EQ(settings.footprint, footprint);
    EXPECT_LE(settings.cellSize, footprint);
    if (footprint < 3e-3f) continue;
    DensityMap map;
    test::shadow(hair, settings, light, map);
    EXPECT_FALSE(map.aliased()) << footprint;
  }
  for (float bad : {0.0f, -1.0f, NAN, INFINITY})
    EXPECT_THROW(automaticMapSettings(hair, makeLightSpace(kSlanted), bad), Error) << bad;
}

}  // namespace
}  // namespace hair

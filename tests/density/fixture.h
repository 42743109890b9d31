#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/random.h>
#include <libhair/core/strands.h>
#include <libhair/core/transform.h>
#include <libhair/density/density_grid.h>
#include <libhair/density/grid_cells.h>

namespace hair::test {

/// Random strands on a ball of 9 cm, falling and waving: a head of hair, roughly.
inline StrandSet headOfHair(std::uint32_t strandCount, std::uint32_t pointsPerStrand,
                            float length = 0.25f, glm::vec3 centre = glm::vec3(0)) {
  StrandSet strands;
  std::vector<glm::vec3> points(pointsPerStrand);
  for (std::uint32_t s = 0; s < strandCount; ++s) {
    const float y = 0.1f + 0.9f * uniform(s, 1), angle = 6.2831853f * uniform(s, 2);
    const float ring = std::sqrt(1 - y * y);
    const glm::vec3 normal(ring * std::cos(angle), y, ring * std::sin(angle));
    const float step = length / static_cast<float>(pointsPerStrand - 1);
    glm::vec3 p = centre + 0.09f * normal, d = normal;
    for (std::uint32_t k = 0; k < pointsPerStrand; ++k) {
      points[k] = p;
      const float t = static_cast<float>(k) * step / 0.06f;
      const glm::vec3 wave(std::sin(9 * t + 6 * uniform(s, 3)), 0, std::cos(8 * t + uniform(s, 4)));
      d = glm::normalize(d + step / 0.06f * (glm::vec3(0, -1.2f, 0) + 0.5f * wave));
      p += step * d;
    }
    strands.append(points);
  }
  return strands;
}

/// All that goes wrong: strands without points, of one, of many equal ones, segments of no length
/// and far longer than any map, points at the walls of cells, and coordinates where floats are
/// coarser than cells.
inline StrandSet hostileHair(std::uint32_t seed) {
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

inline StrandSet oneStrand(std::vector<glm::vec3> points) {
  StrandSet strands;
  strands.append(points);
  return strands;
}

inline const glm::vec3 kSlanted(0.5f, -0.8f, 0.35f);

/// A grid whose X axis points along `x`.
inline GridSpace along(glm::vec3 x, glm::dvec3 origin = glm::dvec3(0)) {
  x = glm::normalize(x);
  const glm::vec3 y = anyNormal(x);
  return {glm::transpose(glm::mat3(x, y, glm::cross(x, y))), origin};
}

/// A curved grid about `focus`, with its pivot in the world's origin.
inline GridSpace about(glm::vec3 focus) {
  GridSpace space = along(-focus);
  space.curvature = 1 / glm::length(focus);
  return space;
}

/// Sum over all cells, of the amount that was deposited.
inline double total(const DensityGrid& grid) {
  double sum = 0;
  for (std::uint32_t slot = 1; slot <= grid.cells->bricks.size(); ++slot)
    for (std::size_t c = 0; c < brick::kCells; ++c) sum += grid.cells->bricks.cells(slot)[c];
  return sum * static_cast<double>(grid.quantum);
}

inline constexpr Deposit kDeposits[] = {Deposit::Points, Deposit::Columns, Deposit::Segments};

}  // namespace hair::test

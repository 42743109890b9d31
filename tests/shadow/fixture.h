#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/random.h>
#include <libhair/core/strands.h>
#include <libhair/density/deposit.h>
#include <libhair/shadow/filter.h>
#include <libhair/shadow/transmittance.h>

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

inline const glm::vec3 kSlanted(0.5f, -0.8f, 0.35f);

/// A fibre that is one hair.
inline Fibre oneHair(float width, float opacity) {
  return {width, opacity, 1.0f};
}

/// The whole pass.
inline std::vector<float> shadow(StrandView strands, const DensityMapSettings& settings,
                                 const LightSpace& light, DensityMap& map,
                                 const Fibre& fibre = {}) {
  std::vector<float> out(strands.pointCount());
  clear(map, settings, light);
  deposit(strands, fibre, map);
  computeTransmittance(map);
  sampleTransmittance(map, strands.points, out);
  return out;
}

inline float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  float most = a.size() == b.size() ? 0.0f : INFINITY;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Sum over all cells, in the map's unit.
inline double total(const DensityMap& map) {
  double sum = 0;
  for (std::uint32_t slot = 1; slot <= map.bricks.size(); ++slot)
    for (std::size_t c = 0; c < brick::kCells; ++c) sum += map.bricks.cells(slot)[c];
  return sum * static_cast<double>(map.quantum);
}

inline constexpr Deposit kDeposits[] = {Deposit::Points, Deposit::Columns, Deposit::Segments};
inline constexpr Filter kFilters[] = {Filter::None, Filter::Paper, Filter::Centred,
                                      Filter::Footprint};

/// Light along +x with y, z as they are: cells are easy to name.
inline LightSpace alongX(glm::dvec3 origin = glm::dvec3(0)) {
  LightSpace light;
  light.origin = origin;
  return light;
}

inline StrandSet oneStrand(std::vector<glm::vec3> points) {
  StrandSet strands;
  strands.append(points);
  return strands;
}

}  // namespace hair::test

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <libhair/shadow/density_map.h>
#include <tests/density/fixture.h>

namespace hair::test {

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

inline constexpr Filter kFilters[] = {Filter::None, Filter::Paper, Filter::Centred,
                                      Filter::Footprint};

/// Light along +x with y, z as they are: cells are easy to name.
inline LightSpace alongX(glm::dvec3 origin = glm::dvec3(0)) {
  LightSpace light;
  light.origin = origin;
  return light;
}

}  // namespace hair::test

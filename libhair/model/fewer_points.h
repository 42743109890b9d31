#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/model/guide_curve.h>

namespace hair {

/// Resamples a strand evenly in the parameter of the Catmull-Rom curve through `all` its points:
/// keeps root and tip bit for bit, and all points where their number does not change. At least 2
/// points of both. (Linear interpolation would make hair around a head shrink.)
inline void takePoints(std::span<const glm::vec3> all, std::span<glm::vec3> some) {
  const std::size_t last = all.size() - 1, most = some.size() - 1;
  for (std::size_t j = 0; j <= most; ++j) {
    const std::size_t i = j * last / most;
    const float t = static_cast<float>(j * last % most) / static_cast<float>(most);
    some[j] = t == 0 ? all[i] : catmullRom(all, i, t);
  }
}

}  // namespace hair

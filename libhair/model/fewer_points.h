#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/model/guide_curve.h>

namespace hair {

/// Points evenly from the Catmull-Rom curve through all of a strand's, by number: root and tip are
/// kept, bit for bit, and as many points as there were are those that there were. At least 2 of
/// both. (Points of the chords would do, but hair that lies round a head would shrink.)
inline void takePoints(std::span<const glm::vec3> all, std::span<glm::vec3> some) {
  const std::size_t last = all.size() - 1, most = some.size() - 1;
  for (std::size_t j = 0; j <= most; ++j) {
    const std::size_t i = j * last / most;
    const float t = static_cast<float>(j * last % most) / static_cast<float>(most);
    some[j] = t == 0 ? all[i] : catmullRom(all, i, t);
  }
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <span>

#include <glm/glm.hpp>

namespace hair {

/// Points evenly from all of a strand's, by number: root and tip are kept, bit for bit, and as many
/// points as there were are those that there were. At least 2 of both.
inline void takePoints(std::span<const glm::vec3> all, std::span<glm::vec3> some) {
  const std::size_t last = all.size() - 1, most = some.size() - 1;
  for (std::size_t j = 0; j <= most; ++j) {
    const std::size_t i = j * last / most;
    const float t = static_cast<float>(j * last % most) / static_cast<float>(most);
    some[j] = t == 0 ? all[i] : all[i] + t * (all[i + 1] - all[i]);
  }
}

}  // namespace hair

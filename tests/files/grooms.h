#pragma once

#include <cmath>

#include <libhair/core/random.h>
#include <libhair/core/strands.h>

namespace hair {

struct SampleGroom {
  std::uint32_t strands = 60, points = 12;
  bool curly = false;
  bool uneven = false;  ///< strands of 2 to `points` points
};

/// Hair on a ball of 0.1 m at the height of a head, that rises and falls; lengths vary.
inline StrandSet sampleGroom(const SampleGroom& wanted = {}) {
  StrandSet strands;
  std::vector<glm::vec3> points;
  for (std::uint32_t s = 0; s < wanted.strands; ++s) {
    const float around = 6.2831853f * uniform(1, s), up = 0.2f + 0.8f * uniform(2, s),
                length = 0.1f + 0.15f * uniform(3, s), side = std::sqrt(1 - up * up);
    const glm::vec3 out(side * std::cos(around), up, side * std::sin(around));
    const std::uint32_t count =
        wanted.uneven
            ? 2 + static_cast<std::uint32_t>(uniform(4, s) * static_cast<float>(wanted.points - 1))
            : wanted.points;
    points.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(wanted.points - 1);
      glm::vec3 p = glm::vec3(0, 1.6f, 0) + (0.1f + length * t) * out;
      p.y -= 0.5f * length * t * t;
      if (wanted.curly) p += 0.01f * t * glm::vec3(std::cos(20 * t), 0, std::sin(20 * t));
      points.push_back(p);
    }
    strands.append(points);
  }
  return strands;
}

}  // namespace hair

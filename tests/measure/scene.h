#pragma once

#include <libhair/core/random.h>
#include <libhair/core/strands.h>
#include <libhair/measure/shadow/truth.h>

namespace hair {

/// Straight strands, 10 cm long, that hang from random places of a square of 6 cm.
inline StrandSet hangingHair(std::uint32_t strands = 300, std::uint32_t points = 9) {
  StrandSet set;
  for (std::uint32_t s = 0; s < strands; ++s) {
    const glm::vec3 root(0.06f * uniform(s, 0), 0, 0.06f * uniform(s, 1));
    std::vector<glm::vec3> strand;
    for (std::uint32_t k = 0; k < points; ++k)
      strand.push_back(root - glm::vec3(0.02f * uniform(s, 2), 0.1f, 0) *
                                  (static_cast<float>(k) / static_cast<float>(points - 1)));
    set.append(strand);
  }
  return set;
}

inline Fibre broadFibre() {
  return {.width = 0.5e-3f, .opacity = 0.6f, .hairsPerStrand = 1};
}

}  // namespace hair

#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <libhair/core/random.h>
#include <libhair/core/transform.h>
#include <libhair/measure/shadow/truth.h>

namespace hair::test {

/// Uniform on the sphere.
inline glm::vec3 randomDirection(std::uint32_t item, std::uint32_t use, std::uint32_t seed = 0) {
  const float z = 2 * uniform(item, use, seed) - 1;
  const float angle = 6.2831853f * uniform(item, use + 100, seed);
  const float ring = std::sqrt(std::max(0.0f, 1 - z * z));
  return {ring * std::cos(angle), ring * std::sin(angle), z};
}

/// In the cube [-half, half]^3.
inline glm::vec3 randomPoint(float half, std::uint32_t item, std::uint32_t use,
                             std::uint32_t seed = 0) {
  return half * (2.0f * glm::vec3(uniform(item, use, seed), uniform(item, use + 1, seed),
                                  uniform(item, use + 2, seed)) -
                 1.0f);
}

/// Strands of `points` points that turn at random, by up to about `bend` radians a joint.
inline StrandSet randomStrands(std::uint32_t count, std::uint32_t points, float step, float bend,
                               float half, std::uint32_t seed = 0) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < count; ++s) {
    std::vector<glm::vec3> p{randomPoint(half, s, 10, seed)};
    glm::vec3 way = randomDirection(s, 20, seed);
    for (std::uint32_t k = 1; k < points; ++k) {
      // Steps differ, and some are far shorter than a fibre is wide.
      const float l = step * std::pow(10.0f, -2 * uniform(s, 1000 + k, seed));
      p.push_back(p.back() + l * way);
      way = glm::normalize(way + bend * randomDirection(s, 3000 + k, seed));
    }
    strands.append(p);
  }
  return strands;
}

inline std::uint32_t crossings(const FibreTracer& tracer, glm::vec3 origin, glm::vec3 toLight,
                               std::uint32_t strand = kNoStrand, float length = INFINITY) {
  const ShadowRay ray{origin, toLight, length, strand};
  std::uint32_t count = 0;
  tracer.countCrossings({&ray, 1}, {&count, 1});
  return count;
}

inline std::vector<std::uint32_t> crossings(const FibreTracer& tracer,
                                            const std::vector<ShadowRay>& rays) {
  std::vector<std::uint32_t> counts(rays.size());
  tracer.countCrossings(rays, counts);
  return counts;
}

}  // namespace hair::test

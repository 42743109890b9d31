#pragma once

#include <cmath>

#include <libhair/model/groom.h>

namespace hair::test {

/// Straight strands on the upper 60 % of a sphere of 0.1 m radius about the origin, roots at
/// Fibonacci points, 0.3 m long: the work that hair solvers are compared on.
inline Groom sphereGroom(std::uint32_t strands, std::uint32_t links, float length = 0.3f) {
  Groom groom;
  groom.pointsPerGuide = links + 1;
  for (std::uint32_t s = 0; s < strands; ++s) {
    const float y = 1 - 1.2f * (static_cast<float>(s) + 0.5f) / static_cast<float>(strands);
    const float a = 2.39996323f * static_cast<float>(s), r = std::sqrt(1 - y * y);
    const glm::vec3 d(r * std::cos(a), y, r * std::sin(a));
    for (std::uint32_t i = 0; i <= links; ++i)
      groom.guidePoints.push_back(
          d * (0.1f + length * static_cast<float>(i) / static_cast<float>(links)));
  }
  return groom;
}

/// The same, every guide drawn.
inline Groom drawnSphereGroom(std::uint32_t strands, std::uint32_t links, float length) {
  Groom groom = sphereGroom(strands, links, length);
  for (std::uint32_t g = 0; g < strands; ++g) {
    groom.parents.push_back(glm::uvec3(g));
    groom.weights.push_back({1, 0, 0});
    groom.first.push_back(groom.first.back() + groom.pointsPerGuide);
  }
  return groom;
}

/// One strand from the origin along `direction`.
inline Groom oneStrand(glm::vec3 direction, float length, std::uint32_t links) {
  Groom groom;
  groom.pointsPerGuide = links + 1;
  for (std::uint32_t i = 0; i <= links; ++i)
    groom.guidePoints.push_back(direction *
                                (length * static_cast<float>(i) / static_cast<float>(links)));
  return groom;
}

}  // namespace hair::test

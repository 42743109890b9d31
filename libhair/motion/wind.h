#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace hair {

/// Moving air: a steady flow, and gusts that travel with it.
struct Wind {
  glm::vec3 velocity{0};    ///< m/s; zero: still air
  float gust = 0.5f;        ///< swing of the speed, as a fraction of it, [0, 1]
  float gustLength = 0.5f;  ///< metres from gust to gust

  /// Speed below 200 m/s, gust in [0, 1], gustLength in [1e-3, 1e6); false for anything that is not
  /// finite.
  bool valid() const {
    return glm::dot(velocity, velocity) < 4e4f && gust >= 0 && gust <= 1 && gustLength >= 1e-3f &&
           gustLength < 1e6f;
  }
  bool still() const { return velocity == glm::vec3(0); }

  /// Velocity of the air at point p (metres) and time t (seconds): incommensurate waves that are
  /// carried along the flow, and a weaker one across it.
  glm::vec3 at(glm::vec3 p, double t) const {
    const float speed = glm::length(velocity);
    if (speed == 0) return glm::vec3(0);
    const glm::vec3 along = velocity / speed;
    const auto phase = static_cast<float>(std::fmod(t * speed / gustLength, 1024.0 * 6.2831853));
    const float s = glm::dot(p, along) / gustLength - phase;
    const float across = (p.y + 0.7f * p.x + 1.3f * p.z) / gustLength;
    const float wave = 0.5f * std::sin(s) + 0.3f * std::sin(2.71f * s + 1.9f * across) +
                       0.2f * std::sin(6.13f * s - 4.3f * across);
    const glm::vec3 side =
        glm::cross(along, std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    return velocity * (1 + gust * wave) +
           side * (0.3f * gust * speed * std::sin(1.7f * s + across));
  }
};

}  // namespace hair

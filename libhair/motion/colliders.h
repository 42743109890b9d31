#pragma once

#include <glm/glm.hpp>

namespace hair {

/// A sphere swept from a to b; a sphere where a == b. Metres, world space.
struct Capsule {
  glm::vec3 a, b;
  float radius;
};

/// xyz = unit direction away from the capsule's axis, w = distance to its surface (metres, negative
/// inside).
inline glm::vec4 distanceAndGradient(const Capsule& c, glm::vec3 p) {
  const glm::vec3 axis = c.b - c.a;
  const float axis2 = glm::dot(axis, axis);
  const float t = axis2 > 0 ? glm::clamp(glm::dot(p - c.a, axis) / axis2, 0.0f, 1.0f) : 0.0f;
  const glm::vec3 out = p - (c.a + t * axis);
  const float r = glm::length(out);
  return {r > 1e-9f ? out / r : glm::vec3(0, 1, 0), r - c.radius};
}

}  // namespace hair

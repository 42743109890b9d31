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

/// Square of the distance to the capsule's axis, m².
inline float axisDistance2(const Capsule& c, glm::vec3 p) {
  const glm::vec3 axis = c.b - c.a, fromA = p - c.a;
  const float axis2 = glm::dot(axis, axis);
  const float t = axis2 > 0 ? glm::clamp(glm::dot(fromA, axis) / axis2, 0.0f, 1.0f) : 0.0f;
  const glm::vec3 out = fromA - t * axis;
  return glm::dot(out, out);
}

/// Least distance between the axes of two capsules, metres.
/// Ericson 2005, "Real-Time Collision Detection", section 5.1.9.
inline float axisDistance(const Capsule& p, const Capsule& q) {
  const glm::vec3 u = p.b - p.a, v = q.b - q.a, w = p.a - q.a;
  const float uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), uw = glm::dot(u, w),
              vw = glm::dot(v, w), det = uu * vv - uv * uv;
  float s = det > 1e-12f ? glm::clamp((uv * vw - uw * vv) / det, 0.0f, 1.0f) : 0.0f;
  const float t = vv > 1e-12f ? glm::clamp((uv * s + vw) / vv, 0.0f, 1.0f) : 0.0f;
  s = uu > 1e-12f ? glm::clamp((uv * t - uw) / uu, 0.0f, 1.0f) : 0.0f;
  return glm::length(w + s * u - t * v);
}

}  // namespace hair

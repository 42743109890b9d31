#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/transform.h>

namespace hair {

/// Angle of the shortest turn between two rotations, degrees.
inline float degreesBetween(const glm::quat& a, const glm::quat& b) {
  // From the chord: the arc cosine of a dot product near 1 has no digits left.
  const glm::quat d = glm::dot(a, b) < 0 ? a + b : a - b;
  return glm::degrees(4.0f * std::asin(std::min(0.5f * glm::length(d), 1.0f)));
}

/// The rotation whose images of +X, +Y, +Z are lateral, up, front: up is kept, front made normal to
/// it. Neither needs to be a unit vector. A rotation whatever they are: an `up` that is no
/// direction is +Y, and where `front` is none, or along `up` (a neck that leaves its chest
/// forward), some front is taken.
inline glm::quat rotationFromUpFront(glm::vec3 up, glm::vec3 front) {
  up = glm::normalize(up);
  if (!std::isfinite(up.x + up.y + up.z)) up = {0, 1, 0};
  glm::vec3 lateral = glm::normalize(glm::cross(up, front));
  if (!std::isfinite(lateral.x + lateral.y + lateral.z)) lateral = anyNormal(up);
  return glm::normalize(glm::quat_cast(glm::mat3(lateral, up, glm::cross(lateral, up))));
}

/// The shortest rotation from unit vector `from` to unit vector `to`; where they are opposite, some
/// half turn.
inline glm::quat turnBetween(glm::vec3 from, glm::vec3 to) {
  const float c = 1 + glm::dot(from, to);
  if (c < 1e-6f) return {0, anyNormal(from)};
  return glm::normalize(glm::quat(c, glm::cross(from, to)));
}

}  // namespace hair

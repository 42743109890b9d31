#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Rotation, then translation (metres). Names compose by eye: worldFromHead * headFromLocal.
struct RigidTransform {
  glm::quat rotation{1, 0, 0, 0};  ///< unit; w first
  glm::vec3 translation{0};        ///< metres

  /// Transforms a point.
  glm::vec3 point(glm::vec3 p) const { return rotation * p + translation; }
  /// Transforms a vector: rotates it only.
  glm::vec3 vector(glm::vec3 v) const { return rotation * v; }
};

/// Composition: first b, then a.
inline RigidTransform operator*(const RigidTransform& a, const RigidTransform& b) {
  return {glm::normalize(a.rotation * b.rotation), a.point(b.translation)};
}

/// The inverse transform.
inline RigidTransform inverse(const RigidTransform& a) {
  const glm::quat r = glm::conjugate(a.rotation);
  return {r, -(r * a.translation)};
}

/// Interpolates from a (t = 0) to b (t = 1): shortest rotation at constant speed, straight path.
inline RigidTransform blend(const RigidTransform& a, const RigidTransform& b, float t) {
  return {glm::normalize(glm::slerp(a.rotation, b.rotation, t)),
          glm::mix(a.translation, b.translation, t)};
}

/// Rotates v as the shortest rotation turns unit vector `from` into unit vector `to` (parallel
/// transport over one bend). A half turn has no shortest rotation: v is then mirrored through
/// the plane normal to `from`, which also maps from to to.
inline glm::vec3 transport(glm::vec3 v, glm::vec3 from, glm::vec3 to) {
  const glm::vec3 h = from + to;
  const float hh = glm::dot(h, h);
  if (hh < 1e-12f) return v - 2.0f * glm::dot(v, from) * from;
  // Two reflections: along from, then along the half vector.
  const glm::vec3 r = v - 2.0f * glm::dot(v, from) * from;
  return r - (2.0f * glm::dot(r, h) / hh) * h;
}

/// Some unit vector at a right angle to unit vector d, smooth but at one pole.
/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
inline glm::vec3 anyNormal(glm::vec3 d) {
  const float s = d.z < 0 ? -1.0f : 1.0f;
  const float a = -1.0f / (s + d.z);
  return {1.0f + s * d.x * d.x * a, s * d.x * d.y * a, -s * d.x};
}

}  // namespace hair

#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>

namespace HAIR_API hair {

class MeshSdf;

/// A sphere swept from a to b; a sphere where a == b. Metres, world space.
struct Capsule {
  glm::vec3 a,   ///< one end of the axis
      b;         ///< the other end
  float radius;  ///< metres
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

/// A half-space: all behind the plane is solid. `point` moves with the surface: its motion along
/// the plane carries hair that lies on it, by friction.
struct Plane {
  glm::vec3 point{0};         ///< anywhere on it, metres, world space
  glm::vec3 normal{0, 1, 0};  ///< unit; to the free side
};

/// A closed mesh by its distance field (sharedSdf), placed at worldFromMesh.point(scale · p).
struct MeshCollider {
  const MeshSdf* sdf = nullptr;    ///< not owned, not null
  RigidTransform worldFromMesh{};  ///< rotation and position of the mesh
  float scale = 1;                 ///< [1e-6, 1000)
};

/// Colliders besides head and body: floor, furniture, a hat, a scanned body.
struct Scenery {
  std::span<const Plane> planes{};         ///< at most kMaxPlanes
  std::span<const MeshCollider> meshes{};  ///< at most kMaxMeshes

  /// No planes and no meshes.
  bool empty() const { return planes.empty() && meshes.empty(); }
};

/// Most capsules that a body may have.
inline constexpr std::size_t kMaxCapsules = 64;

/// Largest number of planes of a Scenery.
inline constexpr std::size_t kMaxPlanes = 8;
/// Largest number of meshes of a Scenery.
inline constexpr std::size_t kMaxMeshes = 8;
/// Least MeshCollider::scale.
inline constexpr float kSmallestMeshScale = 1e-6f;

/// Head, body and scenery at the end of a step, and before it.
struct ColliderState {
  RigidTransform worldFromHead,       ///< at the end
      worldFromHeadBefore;            ///< before
  std::span<const Capsule> capsules,  ///< at the end
      capsulesBefore;                 ///< before; same count and order
  const MeshSdf* head = nullptr;      ///< in head space; may be null
  Scenery scenery{};                  ///< planes and meshes at the end
};

/// Throws Error, naming the collider and the cause, for too many of a kind, normals and rotations
/// that are not unit, scales out of range, meshes without a distance field, and positions that are
/// not finite or beyond 1e15 m.
void validate(const Scenery& scenery);

/// As for a capsule: xyz = unit direction to the free side, w = metres to the surface, negative
/// inside.
inline glm::vec4 distanceAndGradient(const Plane& plane, glm::vec3 p) {
  return {plane.normal, glm::dot(plane.normal, p - plane.point)};
}
/// As MeshSdf::distanceAndGradient, in world space.
glm::vec4 distanceAndGradient(const MeshCollider& mesh, glm::vec3 p);

/// Interpolates from `before` (t = 0) to `after` (t = 1): the shortest rotation at constant speed,
/// and a straight path.
Plane blend(const Plane& before, const Plane& after, float t);
/// The same for a mesh; both have the same distance field.
MeshCollider blend(const MeshCollider& before, const MeshCollider& after, float t);

}  // namespace hair

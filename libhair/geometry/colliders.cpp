#include <libhair/geometry/colliders.h>

#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/geometry/mesh_sdf.h>

namespace hair {

namespace {

// Beyond, distances overflow. Written so that NaN fails too.
bool inReach(glm::vec3 p) {
  return glm::dot(p, p) < 1e30f;
}

}  // namespace

void validate(const Scenery& scenery) {
  require(scenery.planes.size() <= kMaxPlanes, "colliders: ", scenery.planes.size(),
          " planes; at most ", kMaxPlanes);
  require(scenery.meshes.size() <= kMaxMeshes, "colliders: ", scenery.meshes.size(),
          " meshes; at most ", kMaxMeshes);
  for (std::size_t i = 0; i < scenery.planes.size(); ++i) {
    const Plane& plane = scenery.planes[i];
    const float length = glm::length(plane.normal);
    require(std::abs(length - 1) < 1e-3f, "plane ", i, ": a normal of length ", length,
            " is not unit; normalize it");
    require(inReach(plane.point), "plane ", i,
            ": its point is not finite, or beyond 1e15 m; take one nearer to the hair");
  }
  for (std::size_t i = 0; i < scenery.meshes.size(); ++i) {
    const MeshCollider& mesh = scenery.meshes[i];
    require(mesh.sdf != nullptr, "mesh collider ", i,
            ": no distance field; give it one of sharedSdf");
    require(mesh.scale >= kSmallestMeshScale && mesh.scale < 1e3f, "mesh collider ", i,
            ": scale = ", mesh.scale, " is not in [1e-6, 1000)");
    const float length = glm::length(mesh.worldFromMesh.rotation);
    require(std::abs(length - 1) < 1e-3f, "mesh collider ", i, ": a rotation of length ", length,
            " is not unit; normalize it");
    require(inReach(mesh.worldFromMesh.translation), "mesh collider ", i,
            ": its translation is not finite, or beyond 1e15 m");
  }
}

glm::vec4 distanceAndGradient(const MeshCollider& mesh, glm::vec3 p) {
  const glm::vec3 local = inverse(mesh.worldFromMesh).point(p) / mesh.scale;
  const glm::vec4 d = mesh.sdf->distanceAndGradient(local);
  return {mesh.worldFromMesh.vector(glm::vec3(d)), mesh.scale * d.w};
}

Plane blend(const Plane& before, const Plane& after, float t) {
  const RigidTransform start{glm::quat(1, 0, 0, 0), before.point};
  const RigidTransform end{turnBetween(before.normal, after.normal), after.point};
  const RigidTransform between = blend(start, end, t);
  return {between.translation, between.vector(before.normal)};
}

MeshCollider blend(const MeshCollider& before, const MeshCollider& after, float t) {
  return {after.sdf, blend(before.worldFromMesh, after.worldFromMesh, t),
          glm::mix(before.scale, after.scale, t)};
}

}  // namespace hair

#pragma once

#include <memory>

#include <libhair/geometry/colliders.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/geometry/surface_nets.h>

namespace hair::test {

inline constexpr float kBallCell = 4e-3f;

/// A ball about the origin as a mesh, and its distances: right to a tenth of a cell.
inline TriangleMesh ballMesh(float radius) {
  const glm::vec3 reach(radius + 0.02f);
  return surfaceNets([=](glm::vec3 p) { return glm::length(p) - radius; }, {-reach, reach}, 5e-3f);
}
/// A capsule about the z-axis.
inline std::shared_ptr<const MeshSdf> barSdf(float radius, float halfLength) {
  const Capsule bar{{0, 0, -halfLength}, {0, 0, halfLength}, radius};
  const glm::vec3 reach(radius + 0.02f, radius + 0.02f, radius + halfLength + 0.02f);
  return sharedSdf(surfaceNets([=](glm::vec3 p) { return distanceAndGradient(bar, p).w; },
                               {-reach, reach}, 5e-3f),
                   kBallCell, 0.04f);
}
inline std::shared_ptr<const MeshSdf> ballSdf(float radius) {
  return sharedSdf(ballMesh(radius), kBallCell, 0.04f);
}
inline MeshCollider meshAt(const MeshSdf& sdf, glm::vec3 at, float scale = 1) {
  return {&sdf, {{1, 0, 0, 0}, at}, scale};
}

}  // namespace hair::test

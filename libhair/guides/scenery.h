#pragma once

#include <vector>

#include <libhair/core/strands.h>
#include <libhair/geometry/colliders.h>

namespace hair {

/// A plane at the end of a substep. During it, its surface moved by carry · (p - point) + drift at
/// p.
struct PlanePlace {
  glm::vec3 normal,  ///< unit, to the free side
      point;         ///< on the plane, metres
  glm::mat3 carry;   ///< see above
  glm::vec3 drift;   ///< see above, metres
};

/// A mesh at the end of a substep, and before it.
struct MeshPlace {
  const MeshSdf* sdf;             ///< distance field, not owned
  glm::mat3 meshFromWorld;        ///< rotation and scale, applied to p - at
  glm::mat3 turn;                 ///< worldFromMesh, without the scale
  glm::vec3 at;                   ///< origin of the mesh, metres
  float scale;                    ///< of the mesh, as MeshCollider has it
  glm::mat3 worldFromMeshBefore;  ///< rotation and scale before
  glm::vec3 atBefore;             ///< origin of the mesh before, metres
  Bounds box;                     ///< of its grid, world space
};

/// Interpolates planes and meshes at the ends of the substeps of a frame, relative to `origin`:
/// `planes` [substeps · planeCount], `meshes` [substeps · meshCount]. Where `before` holds none of
/// a kind, these did not move. Throws Error for invalid scenery, and for counts that differ.
void cutScenery(const Scenery& before, const Scenery& after, glm::vec3 origin, std::size_t substeps,
                std::vector<PlanePlace>& planes, std::vector<MeshPlace>& meshes);

}  // namespace hair

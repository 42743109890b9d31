#pragma once

#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/colliders.h>

namespace HAIR_API hair {

/// A plane at the end of a substep. Its surface moved by carry · (p - point) + drift at p.
struct PlanePlace {
  glm::vec3 normal,  ///< unit, to the free side
      point;         ///< on the plane, metres
  glm::mat3 carry;   ///< see above
  glm::vec3 drift;   ///< see above, metres
};

/// A mesh at the end of a substep, and where it was before.
struct MeshPlace {
  const MeshSdf* sdf;             ///< distance field, not owned
  glm::mat3 meshFromWorld;        ///< of p - at
  glm::mat3 turn;                 ///< worldFromMesh, without the scale
  glm::vec3 at;                   ///< where the mesh's origin is, metres
  float scale;                    ///< of the mesh, as MeshCollider has it
  glm::mat3 worldFromMeshBefore;  ///< rotation and scale before
  glm::vec3 atBefore;             ///< where the mesh's origin was, metres
  Bounds box;                     ///< world space, of all that its grid covers
};

/// Where planes and meshes are, counted from `origin`, in each of so many substeps of a frame, one
/// substep after the other.
/// `before` may be empty of a kind: it stood where it is. Throws Error for scenery that is not
/// valid, and for counts that differ.
void cutScenery(const Scenery& before, const Scenery& after, glm::vec3 origin, std::size_t substeps,
                std::vector<PlanePlace>& planes, std::vector<MeshPlace>& meshes);

}  // namespace hair

#pragma once

#include <vector>

#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/bending.h>
#include <libhair/guides/contact.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/guides/scenery.h>
#include <libhair/motion/wind.h>

namespace hair {

/// What a GuideWorkspace holds.
struct SubstepMemory {
  BendingFactors bending;                   ///< for one length of the substep
  std::vector<RigidTransform> heads;        ///< [substeps + 1]
  std::vector<Capsule> capsules;            ///< [(substeps + 1) · capsuleCount]
  std::vector<CapsuleBoxes> boxes;          ///< [(substeps + 1) · (capsuleCount / 16, rounded up)]
  std::vector<PlanePlace> planes;           ///< [substeps · planeCount]
  std::vector<MeshPlace> meshes;            ///< [substeps · meshCount]
  std::vector<SubstepColliders> colliders;  ///< [substeps], views of the above
  std::vector<WindField> winds;             ///< [substeps]; empty: still air
};

}  // namespace hair

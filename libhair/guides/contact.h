#pragma once

#include <span>

#include <libhair/core/lanes.h>
#include <libhair/core/transform.h>
#include <libhair/motion/colliders.h>

namespace hair {

class MeshSdf;

/// Where colliders are at the end of one substep, and where they were before it.
struct ColliderState {
  RigidTransform worldFromHead, worldFromHeadBefore;
  std::span<const Capsule> capsules, capsulesBefore;  ///< same count and order
  const MeshSdf* head = nullptr;                      ///< in head space; may be null
};

/// The half-space normal · x >= offset in which a point of a strand must stay for one substep, and
/// how far the surface moved in it.
struct ContactPlane {
  LaneVec3 normal;
  Lanes offset;
  LaneVec3 surfaceMove;
};

/// The plane of the collider nearest to each of eight points (deepest, where inside). A lane far
/// from everything gets a plane that never touches. `near` lists the capsules worth looking at.
ContactPlane nearestPlane(LaneVec3 points, Lanes headClearance, float skin,
                          const ColliderState& colliders, std::span<const std::uint16_t> near);

}  // namespace hair

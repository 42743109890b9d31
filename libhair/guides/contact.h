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
  Lanes distance;  ///< of the point to the plane when it was found; no collider is nearer
};

/// A capsule worth looking at, and how far from its axis each of eight strands must keep.
struct NearCapsule {
  const Capsule *now, *before;
  Lanes reach;
};

/// The same for eight strands whose roots are given. A capsule that has swallowed a root (the neck
/// does, when the head is thrown back) keeps that strand only as far out as its root: there is no
/// way out for the points next to it.
NearCapsule nearCapsule(const Capsule& now, const Capsule& before, LaneVec3 roots, float skin);

/// The plane of the collider nearest to each of eight points (deepest, where inside). A lane far
/// from everything gets a plane that never touches.
ContactPlane nearestPlane(LaneVec3 points, Lanes headClearance, const ColliderState& colliders,
                          std::span<const NearCapsule> near);

}  // namespace hair

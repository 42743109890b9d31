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

/// The points next to the root go where the head goes. Where a capsule has swallowed the place that
/// the head holds for one of them (the neck does, when the head is thrown back), there is no way
/// out: it keeps that point only as far from its axis as that place is, and the points after it
/// farther and farther, by this share of the way along the strand.
inline constexpr std::uint32_t kAnchoredPoints = 3;
inline constexpr float kReachGrowth = 0.7f;

/// A capsule worth looking at.
struct NearCapsule {
  const Capsule *now, *before;
  /// [i]: how far from its axis point i + 1 must keep; points after the last of them that far plus
  /// their way along the strand times kReachGrowth; at most `full`.
  Lanes reach[kAnchoredPoints];
  float full;

  Lanes reachOf(std::uint32_t point, Lanes way) const {
    return point <= kAnchoredPoints
               ? reach[point - 1]
               : min(reach[kAnchoredPoints - 1] + kReachGrowth * way, lanes(full));
  }
};

/// `anchors`: where the head holds points 1 to kAnchoredPoints of eight strands.
NearCapsule nearCapsule(const Capsule& now, const Capsule& before, const LaneVec3* anchors,
                        float skin);

/// How far eight points are from body and head at least: what is known before they are looked at,
/// and more exactly afterwards. A step along a strand takes its length off both; twice that off the
/// body's where a capsule has swallowed something, as its reach may change as much.
struct Clearance {
  Lanes body{}, head{};

  void step(Lanes way, bool swallowed) {
    body = body - (swallowed ? 2.0f : 1.0f) * way, head = head - way;
  }
};

/// The plane of the collider nearest to each of eight points (deepest, where inside), which are
/// points `index` of their strands, `way` metres after the last anchored one. A lane far from
/// everything gets a plane that never touches. Colliders that `clearance` knows to be far are not
/// looked at. `slack`: so many metres less than asked for need to be kept.
ContactPlane nearestPlane(LaneVec3 points, std::uint32_t index, Lanes way, Lanes headClearance,
                          const ColliderState& colliders, std::span<const NearCapsule> near,
                          float slack, Clearance& clearance);

}  // namespace hair

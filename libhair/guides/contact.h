#pragma once

#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/lanes.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/scenery.h>

namespace HAIR_API hair {

class MeshSdf;

/// Where colliders are at the end of one substep, and where they were before it.
struct ColliderState {
  RigidTransform worldFromHead,       ///< at the end
      worldFromHeadBefore;            ///< before
  std::span<const Capsule> capsules,  ///< at the end
      capsulesBefore;                 ///< before; same count and order
  const MeshSdf* head = nullptr;      ///< in head space; may be null
  Scenery scenery{};                  ///< planes and meshes at the end
};

/// The points next to the root go where the head goes. Where a collider has swallowed the place
/// that the head holds for one of them (the neck does, when the head is thrown back), there is no
/// way out: it keeps that point only as far off as that place is, and the points after it farther
/// and farther, by this share of the way along the strand.
inline constexpr std::uint32_t kAnchoredPoints = 3;
/// The share that kAnchoredPoints speaks of.
inline constexpr float kReachGrowth = 0.7f;

/// Capsules of a body, at the most.
inline constexpr std::size_t kMaxCapsules = 64;

/// Metres. Strands do not look farther than this for capsules.
inline constexpr float kSight = 0.01f;

/// Boxes around sixteen capsules and all that may touch them, and in which their surfaces moved
/// since the substep before. Those beyond the last hold nothing.
struct CapsuleBoxes {
  LaneVec3 lower,      ///< corners of the boxes towards -x, -y, -z, metres
      upper;           ///< corners towards +x, +y, +z
  LaneVec3 leastMove,  ///< least motion of the surface along x, y and z, metres
      mostMove;        ///< and the greatest
};

/// A ColliderState as the solver wants it, made once for all strands.
struct SubstepColliders {
  glm::mat3 turn,                       ///< rotation of the head, worldFromHead, at the end
      turnBefore;                       ///< and before
  glm::vec3 at,                         ///< where the head's origin is at the end, metres
      atBefore;                         ///< and before
  std::span<const Capsule> capsules,    ///< at the end
      capsulesBefore;                   ///< before; same count and order
  std::span<const CapsuleBoxes> boxes;  ///< [capsules / 16, rounded up]
  const MeshSdf* head = nullptr;        ///< in head space; may be null
  std::span<const PlanePlace> planes;   ///< [planes] of this substep
  std::span<const MeshPlace> meshes;    ///< [meshes] of this substep
};

/// Appends the boxes of these capsules, `reach` metres larger. `before`: same count and order.
void appendBoxes(std::span<const Capsule> capsules, std::span<const Capsule> before, float reach,
                 std::vector<CapsuleBoxes>& boxes);

}  // namespace hair

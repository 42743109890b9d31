#pragma once

#include <span>
#include <vector>

#include <libhair/core/lanes.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/scenery.h>

namespace hair {

class MeshSdf;

/// The first points after the root move with the head. If a collider covers the rest position of
/// one of them (the neck does when the head is thrown back), no valid position exists: the required
/// distance of that point is reduced to that of its rest position and half the skin, and grows back
/// along the strand at the rate kReachGrowth.
inline constexpr std::uint32_t kAnchoredPoints = 3;
/// Growth of the required distance after the last anchored point, metres per metre of strand.
inline constexpr float kReachGrowth = 0.7f;

/// Metres beyond the skin within which strands look for capsules, planes and meshes.
inline constexpr float kSight = 0.01f;

/// For sixteen capsules, the boxes in which points may touch them, and bounds of the motion of
/// their surfaces since the previous substep. Lanes beyond the last capsule hold empty boxes.
struct CapsuleBoxes {
  LaneVec3 lower,      ///< corners of the boxes towards -x, -y, -z, metres
      upper;           ///< corners towards +x, +y, +z
  LaneVec3 leastMove,  ///< least motion of the surface along x, y and z, metres
      mostMove;        ///< and the greatest
};

/// The colliders of one substep in the form that the solver reads, made once for all strands.
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

/// Appends the boxes of these capsules, enlarged by `reach` metres. `before`: same count and order.
void appendBoxes(std::span<const Capsule> capsules, std::span<const Capsule> before, float reach,
                 std::vector<CapsuleBoxes>& boxes);

}  // namespace hair

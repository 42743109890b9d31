#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/bending.h>
#include <libhair/guides/contact.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/motion/wind.h>

namespace HAIR_API hair {

/// What carries and pushes the guides over one frame. Roots and colliders are interpolated inside
/// the frame, from where the guides were left to what stands here.
struct GuideMotion {
  RigidTransform worldFromHead{};             ///< at the end of the frame
  std::span<const Capsule> capsules{};        ///< body at the end of the frame
  std::span<const Capsule> capsulesBefore{};  ///< at its start; same count and order
  const MeshSdf* head = nullptr;              ///< collider in head space; null: none
  Wind wind{};                                ///< still air by default
  double time = 0;                     ///< at the start of the frame, seconds; moves the gusts
  std::span<const LaneVec3> push{};    ///< m/s² on every point, laid out as GuideStrands; or empty
  std::span<const Lanes> windShare{};  ///< of the wind that gets to every point; or empty: all
  Scenery scenery{};                   ///< at the end of the frame
  Scenery sceneryBefore{};             ///< at its start; same counts and order, or none: it stood
};

/// What stepGuides needs beside its inputs; kept by the caller, grown once.
struct GuideWorkspace {
  BendingFactors bending;                   ///< of one length of substep
  std::vector<RigidTransform> heads;        ///< [substeps + 1]
  std::vector<Capsule> capsules;            ///< [(substeps + 1) · capsuleCount]
  std::vector<CapsuleBoxes> boxes;          ///< of the same, sixteen at a time
  std::vector<PlanePlace> planes;           ///< [substeps · planeCount]
  std::vector<MeshPlace> meshes;            ///< [substeps · meshCount]
  std::vector<SubstepColliders> colliders;  ///< [substeps], of all these
  std::vector<WindField> winds;             ///< [substeps]; empty: still air
};

/// Moves the guides over one frame of `seconds`. Each substep of length h:
///   1. predict: velocity with drag, gravity, push, and the tension of the substep before;
///   2. bend: implicit Euler on the bending energy (bending.h), one solve;
///   3. contact: the nearest collider's plane for each point, with friction (contact-inl.h);
///   4. links: Newton iterations, all links of a strand at once (links-inl.h), then exact lengths;
///      or relaxation, one link after the other (relaxation-inl.h), with the stretch that it
///      leaves;
///   5. velocity = movement / h.
/// Predicting with the last tension makes a groom at rest a fixed point of every substep, and is a
/// good start for Newton otherwise. (Relaxation leaves tension as it is.)
/// Throws Error: seconds not in [1e-6, 1], settings out of range, counts that differ, wind, head,
/// capsules, scenery or pushes that are not valid, a head too far from the origin (validate.h). One
/// workspace goes with one GuideStrands.
void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& workspace, GuideStrands& guides);

}  // namespace hair

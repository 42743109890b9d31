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

/// What moves the guides over one frame. Roots and colliders are interpolated inside the frame,
/// from where they were at its start to where they are at its end.
struct GuideMotion {
  RigidTransform worldFromHead{};             ///< at the end of the frame
  std::span<const Capsule> capsules{};        ///< body at the end of the frame
  std::span<const Capsule> capsulesBefore{};  ///< at its start; same count and order
  const MeshSdf* head = nullptr;              ///< collider in head space; null: none
  Wind wind{};                                ///< still air by default
  double time = 0;                     ///< at the start of the frame, seconds; phase of the gusts
  std::span<const LaneVec3> push{};    ///< m/s² on every point, laid out as GuideStrands; or empty
  std::span<const Lanes> windShare{};  ///< fraction of the wind at every point; or empty: 1
  Scenery scenery{};                   ///< at the end of the frame
  Scenery sceneryBefore{};             ///< at its start; same counts and order, or empty: at rest
};

/// Working memory of stepGuides; kept by the caller, so that it is allocated once.
struct GuideWorkspace {
  BendingFactors bending;                   ///< for one length of the substep
  std::vector<RigidTransform> heads;        ///< [substeps + 1]
  std::vector<Capsule> capsules;            ///< [(substeps + 1) · capsuleCount]
  std::vector<CapsuleBoxes> boxes;          ///< [(substeps + 1) · (capsuleCount / 16, rounded up)]
  std::vector<PlanePlace> planes;           ///< [substeps · planeCount]
  std::vector<MeshPlace> meshes;            ///< [substeps · meshCount]
  std::vector<SubstepColliders> colliders;  ///< [substeps], views of the above
  std::vector<WindField> winds;             ///< [substeps]; empty: still air
};

/// Moves the guides over one frame of `seconds`. Each substep of length h:
///   1. predict: velocity with drag, gravity, push, and the tension of the previous substep;
///   2. bend: implicit Euler on the bending energy (bending.h), one solve;
///   3. contact: the nearest collider's plane for each point, with friction (contact-inl.h);
///   4. links: Newton iterations, all links of a strand at once (links-inl.h), then exact lengths;
///      or relaxation, one link after the other (relaxation-inl.h), which leaves some stretch;
///   5. velocity = movement / h.
/// Predicting with the last tension makes a groom at rest a fixed point of every substep, and
/// starts Newton close to its solution otherwise. (Relaxation does not change the tension.)
/// Throws Error for seconds not in [1e-6, 1], settings out of range, counts that differ, more than
/// kMaxCapsules capsules, invalid wind, head, capsules, scenery or pushes, and a head too far from
/// the origin (validate.h). Use one workspace per GuideStrands.
void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& workspace, GuideStrands& guides);

}  // namespace hair

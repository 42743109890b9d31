// Broad phase: the capsules near sixteen strands; included by the solver's kernel
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_NEARBY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_NEARBY_INL_H
#undef HAIR_GUIDES_NEARBY_INL_H
#else
#define HAIR_GUIDES_NEARBY_INL_H
#endif

#include <algorithm>
#include <bit>
#include <span>

#include <libhair/core/simd-inl.h>
#include <libhair/guides/contact_plane-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// A capsule near the strands, prepared for distance queries.
struct NearCapsule {
  glm::vec3 a, axis, moveA, moveAxis;  ///< move...: change since the previous substep, metres
  float perAxis2;                      ///< 1 / |axis|², 0 for a sphere
  RequiredDistance reach;              ///< required distance from its axis
};

/// The point of a capsule's axis nearest to a point: a + t · axis.
struct Foot {
  Floats t;
  Vec3 point;
};

HWY_INLINE Foot footOf(const NearCapsule& c, const Vec3& p) {
  const Vec3 a(c.a), axis(c.axis);
  const Floats t = min(max(Floats(c.perAxis2) * dot(p - a, axis), Floats(0.0f)), Floats(1.0f));
  return {t, a + t * axis};
}

/// Prepares a capsule. `anchors`: rest positions, carried by the head, of points 1 to
/// kAnchoredPoints of sixteen strands.
HWY_INLINE void prepareCapsule(const Capsule& now, const Capsule& before, const Vec3* anchors,
                               float skin, NearCapsule& near) {
  const glm::vec3 axis = now.b - now.a;
  const float axis2 = glm::dot(axis, axis);
  near.a = now.a, near.axis = axis;
  near.moveA = now.a - before.a, near.moveAxis = (now.b - before.b) - near.moveA;
  near.perAxis2 = axis2 > 0 ? 1.0f / axis2 : 0.0f;
  Floats held[kAnchoredPoints];
  for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
    held[i] = length(anchors[i] - footOf(near, anchors[i]).point);
  near.reach.set(held, now.radius + skin, skin);
}

/// The capsules near sixteen strands, one bit each, and bounds of the motion of their surfaces,
/// metres.
struct Near {
  std::uint64_t capsules = 0;
  glm::vec3 leastMove{0}, mostMove{0};
};

/// A bounding box in each lane, of one strand; least and most are those of all sixteen.
struct Box {
  Vec3 lower, upper;

  HWY_INLINE void add(const Vec3& least, const Vec3& most) {
    lower = {min(lower.x, least.x), min(lower.y, least.y), min(lower.z, least.z)};
    upper = {max(upper.x, most.x), max(upper.y, most.y), max(upper.z, most.z)};
  }
  HWY_INLINE glm::vec3 least() const { return {lowest(lower.x), lowest(lower.y), lowest(lower.z)}; }
  HWY_INLINE glm::vec3 most() const {
    return {highest(upper.x), highest(upper.y), highest(upper.z)};
  }
};

/// Finds the capsules whose boxes meet the box around all points `x` [points] of sixteen strands.
HWY_INLINE Near findNear(std::uint32_t points, const Vec3* x, const SubstepColliders& colliders) {
  Near near;
  if (colliders.capsules.empty()) return near;
  Box all{x[0], x[0]};
  for (std::uint32_t i = 1; i < points; ++i) all.add(x[i], x[i]);
  const Vec3 least{all.least()}, most{all.most()}, far{glm::vec3(kFar)}, minusFar{glm::vec3(-kFar)};
  Box moves{far, minusFar};
  for (std::size_t b = 0; b < colliders.boxes.size(); ++b) {
    const CapsuleBoxes& box = colliders.boxes[b];
    const Vec3 from(box.lower), to(box.upper);
    const Mask meet = (from.x < most.x) & (from.y < most.y) & (from.z < most.z) & (least.x < to.x) &
                      (least.y < to.y) & (least.z < to.z);
    near.capsules |= std::uint64_t{bits(meet)} << (b * kLanes);
    moves.add(select(meet, Vec3(box.leastMove), far), select(meet, Vec3(box.mostMove), minusFar));
  }
  if (near.capsules) near.leastMove = moves.least(), near.mostMove = moves.most();
  return near;
}

/// The colliders near sixteen strands, prepared by prepareCapsules.
struct Surroundings {
  const SubstepColliders& colliders;
  std::span<const NearCapsule> capsules;
  float seen;    ///< lower bound of the distance to all other capsules, metres
  bool covered;  ///< a capsule covers the rest position of an anchored point (RequiredDistance)
};

/// Rest positions, carried by the head, of points 1 to kAnchoredPoints of sixteen strands; `rest`
/// [points] in head space.
HWY_INLINE void findAnchors(std::uint32_t points, const LaneVec3* rest,
                            const SubstepColliders& colliders, Vec3* anchors) {
  for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
    anchors[i] = rotate(colliders.turn, rest[std::min(i + 1, points - 1)]) + Vec3(colliders.at);
}

/// Prepares these capsules (one bit each) in `room` [kMaxCapsules], the first time that it is
/// called in a substep. `rest` [points]: rest positions of the strands, in head space.
HWY_INLINE void prepareCapsules(std::uint32_t points, const LaneVec3* rest, float skin,
                                std::uint64_t capsules, NearCapsule* room, Surroundings& around) {
  if (around.capsules.data()) return;
  const SubstepColliders& colliders = around.colliders;
  Vec3 anchors[kAnchoredPoints];
  findAnchors(points, rest, colliders, anchors);
  std::size_t count = 0;
  for (; capsules != 0; capsules &= capsules - 1) {
    const auto c = static_cast<std::size_t>(std::countr_zero(capsules));
    NearCapsule& near = room[count++];
    prepareCapsule(colliders.capsules[c], colliders.capsulesBefore[c], anchors, skin, near);
    around.covered |= near.reach.covered();
  }
  around.capsules = {room, count};
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

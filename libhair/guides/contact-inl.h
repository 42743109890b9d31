// Colliders of sixteen strands at once; included by the solver's kernel (core/simd-inl.h).
#if defined(HAIR_GUIDES_CONTACT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_CONTACT_INL_H
#undef HAIR_GUIDES_CONTACT_INL_H
#else
#define HAIR_GUIDES_CONTACT_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/geometry/mesh_sdf-inl.h>
#include <libhair/guides/nearby-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// Farther than links drag most points in a substep: those that go farther look again (substep).
inline constexpr float kFarEnough = 1e-3f;
// As much as the distance to the head may change over a metre: that of neighbouring nodes changes
// by a cell at most, along each axis; and more than there is for what far nodes may be wrong by.
inline constexpr float kHeadSlope = 1.75f;

/// How far points are from body and head at least.
struct Clearance {
  Floats body, head;

  Clearance() = default;
  HWY_INLINE explicit Clearance(float both) : body(both), head(both) {}
  HWY_INLINE Mask within(float distance) const { return !(min(body, head) > Floats(distance)); }
};

/// How to look: only planes `within` so many metres are of use, and so many metres less than asked
/// for need to be kept.
struct Look {
  float within, slack;
};

/// Keeps in `best` the plane of a capsule where that is nearer than what it holds, or its distance
/// alone where that is beyond `within`; true if it was a plane anywhere.
HWY_INLINE bool nearerCapsule(const Vec3& p, const NearCapsule& capsule, Floats reach, float within,
                              ContactPlane& best) {
  const Foot foot = footOf(capsule, p);
  const Vec3 out = p - foot.point;
  // Most capsules are farther than what is held already: no root is needed to see that.
  const Floats length2 = dot(out, out), far = best.distance + reach;
  if (!any(length2 < far * far)) return false;
  const Floats r = sqrt(length2), d = r - reach;
  const Mask nearer = d < best.distance;
  best.distance = select(nearer, d, best.distance);
  if (!any(nearer & !(d > Floats(within)))) return false;
  const Vec3 normal = (Floats(1.0f) / max(r, Floats(1e-9f))) * out;
  const Vec3 move = Vec3(capsule.moveA) + foot.t * Vec3(capsule.moveAxis);
  best.normal = select(nearer, normal, best.normal);
  best.offset = select(nearer, dot(normal, foot.point) + reach, best.offset);
  best.surfaceMove = select(nearer, move, best.surfaceMove);
  return true;
}

/// The same for the head, in the lanes that may be near it; `known` is made exact.
HWY_INLINE bool nearerHead(const Vec3& p, Floats keep, const SubstepColliders& colliders,
                           float within, Floats& known, ContactPlane& best) {
  const Mask look = !(known > Floats(within));
  if (!any(look)) {
    best.distance = min(known, best.distance);
    return false;
  }
  const SdfLookup head(*colliders.head);
  const Vec3 local = rotate(glm::transpose(colliders.turn), p - Vec3(colliders.at));
  const Floats bound = head.lowerBound(local, look) - keep;
  const Mask near = look & !(bound > Floats(kSight));
  Floats d = bound;
  if (any(near)) d = select(near, head.distance(local, near) - keep, bound);
  known = select(look, d, known);
  const Mask nearer = known < best.distance, touches = look & nearer & !(known > Floats(within));
  best.distance = select(nearer, known, best.distance);
  best.offset = select(look & nearer, Floats(-kFar), best.offset);
  if (!any(touches)) return false;
  const Vec3 normal = rotate(colliders.turn, head.direction(local, touches));
  const Vec3 move = p - (rotate(colliders.turnBefore, local) + Vec3(colliders.atBefore));
  best.normal = select(touches, normal, best.normal);
  best.offset = select(touches, dot(normal, p) - known, best.offset);
  best.surfaceMove = select(touches, move, best.surfaceMove);
  return true;
}

/// The plane of the collider nearest to each of sixteen points (deepest, where inside), which are
/// points `index` of their strands, `way` metres after the last anchored one. A lane far from
/// everything gets a plane that never touches; false: all are, and only the distance is set.
/// Colliders that `clearance` knows to be far are not looked at, and it is made exact of the
/// others.
HWY_NOINLINE inline bool nearestPlane(const Vec3& p, std::uint32_t index, const Floats& way,
                                      const Floats& headClearance, const Surroundings& around,
                                      const Look& how, Clearance& clearance, ContactPlane& plane) {
  ContactPlane best{Vec3(glm::vec3(0)), -kFar, Vec3(glm::vec3(0)), around.seen};
  bool found = false;
  if (any(!(clearance.body > Floats(how.within)))) {
    for (const NearCapsule& capsule : around.capsules)
      found |= nearerCapsule(p, capsule, capsule.reach.of(index, way) - Floats(how.slack),
                             how.within, best);
    // What a capsule has swallowed may be out again soon.
    clearance.body = around.swallowed ? Floats(0.0f) : best.distance;
  } else {
    best.distance = clearance.body;
  }
  if (around.colliders.head)
    found |= nearerHead(p, headClearance - Floats(how.slack), around.colliders, how.within,
                        clearance.head, best);
  else
    clearance.head = kFar;
  if (found)
    plane = best;
  else
    plane.distance = best.distance;
  return found;
}

/// Coulomb: of the way along the surface, takes back as much as friction can for this push.
HWY_INLINE Vec3 rub(const Vec3& x, const Vec3& before, const ContactPlane& plane, Floats depth,
                    float friction) {
  const Vec3 moved = x - before - plane.surfaceMove;
  const Vec3 along = moved - dot(moved, plane.normal) * plane.normal;
  const Floats way = length(along);
  const Floats taken = min(Floats(friction) * depth, way) / max(way, Floats(1e-12f));
  return x - taken * along;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

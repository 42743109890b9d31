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

// Metres: search distance of the contact pass, farther than the links move most points in a
// substep. Points that move farther are rechecked (recheckContacts).
inline constexpr float kContactRange = 1e-3f;
// Bound of the gradient of the head's distance field, metres per metre. Neighbouring nodes differ
// by at most a cell along each axis, which gives sqrt(3); the rest allows for errors of far nodes.
inline constexpr float kHeadSlope = 1.75f;

/// Lower bounds, metres, of how far points are beyond the distance that they must keep from body
/// and head.
struct Clearance {
  Floats body, head;

  Clearance() = default;
  HWY_INLINE explicit Clearance(float both) : body(both), head(both) {}
  HWY_INLINE Mask within(float distance) const { return !(min(body, head) > Floats(distance)); }
};

/// Parameters of a search: find planes up to `within` metres away, with the required distances
/// reduced by `slack` metres.
struct ContactQuery {
  float within, slack;
};

/// Replaces `best` by the plane of a capsule in the lanes where that is nearer; if all of these are
/// beyond `within`, only its distance. Returns true if it has set a plane.
HWY_INLINE bool nearerCapsule(const Vec3& p, const NearCapsule& capsule, Floats reach, float within,
                              ContactPlane& best) {
  const Foot foot = footOf(capsule, p);
  const Vec3 out = p - foot.point;
  // Reject most capsules by the squared distance, without a square root.
  const Floats length2 = dot(out, out), far = best.distance + reach;
  if (!any(length2 < far * far)) return false;
  const Floats r = sqrt(length2), d = r - reach;
  const Mask nearer = d < best.distance;
  best.distance = select(nearer, d, best.distance);
  if (!any(nearer & !(d > Floats(within)))) return false;
  // Set the tangent plane, and the motion of the surface at the foot.
  const Vec3 normal = (Floats(1.0f) / max(r, Floats(1e-9f))) * out;
  const Vec3 move = Vec3(capsule.moveA) + foot.t * Vec3(capsule.moveAxis);
  best.normal = select(nearer, normal, best.normal);
  best.offset = select(nearer, dot(normal, foot.point) + reach, best.offset);
  best.surfaceMove = select(nearer, move, best.surfaceMove);
  return true;
}

/// The same for the head, in the lanes whose lower bound `known` does not exceed `within`; updates
/// `known`.
HWY_INLINE bool nearerHead(const Vec3& p, Floats keep, const SubstepColliders& colliders,
                           float within, Floats& known, ContactPlane& best) {
  const Mask look = !(known > Floats(within));
  if (!any(look)) {
    best.distance = min(known, best.distance);
    return false;
  }
  // Look up a bound from one node, and the interpolated distance only where that is near.
  const SdfLookup head(*colliders.head);
  const Vec3 local = rotate(glm::transpose(colliders.turn), p - Vec3(colliders.at));
  const Floats bound = head.lowerBound(local, look) - keep;
  const Mask near = look & !(bound > Floats(kSight));
  Floats d = bound;
  if (any(near)) d = select(near, head.distance(local, near) - keep, bound);
  known = select(look, d, known);
  // Keep the nearer distance, with no plane where it is beyond `within`.
  const Mask nearer = known < best.distance, touches = look & nearer & !(known > Floats(within));
  best.distance = select(nearer, known, best.distance);
  best.offset = select(look & nearer, Floats(-kFar), best.offset);
  if (!any(touches)) return false;
  // Set the plane from the gradient, and the motion of the surface from the head's.
  const Vec3 normal = rotate(colliders.turn, head.direction(local, touches));
  const Vec3 move = p - (rotate(colliders.turnBefore, local) + Vec3(colliders.atBefore));
  best.normal = select(touches, normal, best.normal);
  best.offset = select(touches, dot(normal, p) - known, best.offset);
  best.surfaceMove = select(touches, move, best.surfaceMove);
  return true;
}

/// Finds the plane of the capsule or head nearest to each of sixteen points (of the one deepest
/// penetrated, if inside): points `index` of their strands, `way` metres of strand after the last
/// anchored point. A lane far from all gets a plane that nothing touches; returns false if all
/// lanes do, and then sets only the distance. Skips colliders that `clearance` shows to be beyond
/// `how.within`; updates it for the others.
HWY_NOINLINE inline bool nearestPlane(const Vec3& p, std::uint32_t index, const Floats& way,
                                      const Floats& headClearance, const Surroundings& around,
                                      const ContactQuery& how, Clearance& clearance,
                                      ContactPlane& plane) {
  ContactPlane best{Vec3(glm::vec3(0)), -kFar, Vec3(glm::vec3(0)), around.seen};
  bool found = false;
  if (any(!(clearance.body > Floats(how.within)))) {
    for (const NearCapsule& capsule : around.capsules)
      found |= nearerCapsule(p, capsule, capsule.reach.of(index, way) - Floats(how.slack),
                             how.within, best);
    // Required distances may change where a capsule covers anchored points: assume nothing.
    clearance.body = around.covered ? Floats(0.0f) : best.distance;
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

/// Coulomb friction: takes back movement along the surface, relative to it, up to friction · depth.
HWY_INLINE Vec3 applyFriction(const Vec3& x, const Vec3& before, const ContactPlane& plane,
                              Floats depth, float friction) {
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

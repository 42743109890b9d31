// The contacts of sixteen strands at once, from the search for planes to the push out of them;
// included by the solver's kernel (core/simd-inl.h).
#if defined(HAIR_GUIDES_GROUP_CONTACTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_GROUP_CONTACTS_INL_H
#undef HAIR_GUIDES_GROUP_CONTACTS_INL_H
#else
#define HAIR_GUIDES_GROUP_CONTACTS_INL_H
#endif

#include <libhair/guides/contact-inl.h>
#include <libhair/guides/group-inl.h>
#include <libhair/guides/scenery-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Finds the plane of the nearest capsule or of the head for each point. Skips points whose
/// clearance, a lower bound of their distance to all of these, says that none is near.
HWY_INLINE void findPlanes(const Group& g, float skin, const Near& near, Surroundings& around,
                           Scratch& s) {
  // Bound how the colliders moved: capsules by drift ± spread, the head by its rigid motion.
  const SubstepColliders& colliders = around.colliders;
  const glm::mat3 turn = colliders.turn * glm::transpose(colliders.turnBefore);
  const Vec3 at(colliders.at), atBefore(colliders.atBefore);
  const Vec3 drift(0.5f * (near.leastMove + near.mostMove));
  const Floats spread(0.5f * glm::length(near.mostMove - near.leastMove));
  Floats way = 0.0f;
  for (std::uint32_t i = 1; i < g.points; ++i) {
    const Vec3 x = s.x[i], before = s.queriedAt[i];
    Clearance& known = s.clear[i];
    if (i > kAnchoredPoints) way = way + Floats(g.linkLength[i - 1]);
    s.way[i] = way;
    s.queriedAt[i] = x;
    Contact& contact = s.contacts[i];
    contact.touched = contact.near = false;
    // Lower the clearance of the last substep by the motion relative to the colliders.
    const Vec3 carried = rotate(turn, before - atBefore) + at;
    known.body = known.body - (length(x - (before + drift)) + spread);
    known.head = known.head - Floats(kHeadSlope) * length(x - carried);
    contact.plane.distance = min(known.body, known.head);
    if (!any(known.within(kContactRange))) continue;
    // Raise it by what is known of the previous point of the strand.
    const Floats link = length(x - s.x[i - 1]);
    known.body = max(known.body, s.clear[i - 1].body - link);
    known.head = max(known.head, s.clear[i - 1].head - Floats(kHeadSlope) * link);
    // Query the colliders; this also makes the clearance exact.
    prepareCapsules(g.points, g.restPosition, skin, near.capsules, s.near, around);
    contact.near =
        nearestPlane(x, i, way, g.clearance[i], around, {kContactRange, 0}, known, contact.plane);
  }
}

/// Replaces a point's plane where a Plane or a mesh of the scenery is nearer.
HWY_NOINLINE inline NearScenery findSceneryPlanes(const Group& g, float skin,
                                                  const SubstepColliders& colliders, Scratch& s) {
  Vec3 anchors[kAnchoredPoints];
  findAnchors(g.points, g.restPosition, colliders, anchors);
  const NearScenery scenery =
      findScenery(colliders, g.points, s.x, anchors, skin, s.planes, s.meshes);
  if (scenery.empty()) return scenery;
  MeshClearance clearance(scenery);
  for (std::uint32_t i = 1; i < g.points; ++i) {
    clearance.step(length(s.x[i] - s.x[i - 1]));
    Contact& contact = s.contacts[i];
    contact.near =
        nearerScenery(s.x[i], i, s.way[i], scenery, 0, contact.near, clearance.left, contact.plane);
  }
  return scenery;
}

/// Projects points that penetrate their planes onto them, with friction.
HWY_INLINE void pushOut(const Group& g, float friction, Scratch& s) {
  for (std::uint32_t i = 1; i < g.points; ++i) {
    Contact& contact = s.contacts[i];
    if (!contact.near) continue;
    const ContactPlane& plane = contact.plane;
    const Floats depth = plane.offset - dot(plane.normal, s.x[i]);
    const Mask inside = depth > Floats(0.0f);
    if (!any(inside)) continue;
    contact.touching = contact.touched ? contact.touching | inside : inside;
    contact.touched = true;
    const Floats push = select(inside, depth, Floats(0.0f));
    s.x[i] = applyFriction(s.x[i] + push * plane.normal, g.position[i], plane, push, friction);
  }
}

/// Finds the planes again for points that the links moved farther than the collider they
/// were near. True if one penetrates a collider. The skin is a safety margin; here, where a point
/// may be between two colliders, a third of it is enough.
HWY_INLINE bool recheckContacts(const Group& g, float skin, std::uint64_t near,
                                Surroundings& around, const NearScenery& scenery, Scratch& s) {
  const ContactQuery how{kSight, skin * (2.0f / 3.0f)};
  bool again = false;
  for (std::uint32_t i = 1; i < g.points; ++i) {
    // Skip points that cannot have reached a collider yet.
    const Vec3 moved = s.x[i] - s.queriedAt[i];
    ContactPlane& plane = s.contacts[i].plane;
    const Floats may = max(plane.distance, Floats(0.0f)) + Floats(0.5f * skin);
    if (!any(dot(moved, moved) > may * may)) continue;
    prepareCapsules(g.points, g.restPosition, skin, near, s.near, around);
    s.queriedAt[i] = s.x[i];
    s.clear[i] = Clearance(0);
    s.contacts[i].near =
        nearestPlane(s.x[i], i, s.way[i], g.clearance[i], around, how, s.clear[i], plane);
    // Count the clearance from the full skin again.
    s.clear[i].body = s.clear[i].body - Floats(how.slack);
    s.clear[i].head = s.clear[i].head - Floats(how.slack);
    if (!scenery.empty()) {
      Floats unknown = 0.0f;
      s.contacts[i].near = nearerScenery(s.x[i], i, s.way[i], scenery, how.slack,
                                         s.contacts[i].near, unknown, plane);
    }
    again |= any(plane.distance < Floats(0.0f));
  }
  return again;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

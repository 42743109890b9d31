// One substep of length h, of sixteen strands ("a group") at once; point 0 is the root:
//
//      position, velocity, tension
//        |  predict    x = position + h velocity; force = gravity, air, push, tension
//        |  pin        put the root and tied points on the head
//        |  bend       x += (M / h² + K)⁻¹ (force - grad E(x))                  bending-inl.h
//        |  contacts   find the nearest collider's plane, n · x >= offset       contact-inl.h
//    .-> |  links      push x out of the planes, solve |x_(i+1) - x_i| = l_i    links-inl.h
//    '-- |  recheck    find new planes for points that the links moved far
//        v
//      velocity = (x - position) / h,   tension -= lambda / h²
//
// stepGuides, at the end, cuts a frame into substeps and runs those of a group on one thread.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/guides/step.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>
#include <libhair/guides/bending-inl.h>
#include <libhair/guides/contact-inl.h>
#include <libhair/guides/links-inl.h>
#include <libhair/guides/relaxation-inl.h>
#include <libhair/guides/scenery-inl.h>
#include <libhair/motion/wind-inl.h>

#include <algorithm>

#include <libhair/guides/step.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// What a substep reads and writes of one group: pointers into the arrays of GuideStrands.
struct Group {
  std::uint32_t points, tied;
  LaneVec3 *position, *velocity;
  Lanes* tension;
  const LaneVec3 *restPosition, *push;
  const Lanes *windShare, *mass, *inverseMass, *linkLength, *mostTension, *mostCompression,
      *clearance;
  RootFrame rest;
  BendingGroup bending;
  bool hasUnevenLinks;
};

// Scale all tensions of a strand by one factor, so that none exceeds what predict may apply.
// Clamped one by one they would not balance, and throw light points between uneven links.
HWY_NOINLINE void scaleTensions(const Group& g) {
  Floats share = 1.0f;
  for (std::uint32_t i = 0; i + 1 < g.points; ++i) {
    const Floats t = g.tension[i];
    const Floats most = select(t > Floats(0.0f), Floats(g.mostTension[i]), g.mostCompression[i]);
    share = min(share, most / max(abs(t), Floats(1e-20f)));
  }
  for (std::uint32_t i = 0; i + 1 < g.points; ++i)
    store(share * Floats(g.tension[i]), g.tension[i]);
}

// Working memory of a group. Left uninitialised: it is sized for the longest strands.
struct Scratch {
  Vec3 x[kMaxGuidePoints], force[kMaxGuidePoints], queriedAt[kMaxGuidePoints];
  Clearance clear[kMaxGuidePoints];  // of the points at queriedAt
  Vec3 directions[kMaxGuidePoints];  // of the links, unit, after the last substep
  Floats lambda[kMaxGuidePoints], way[kMaxGuidePoints];
  Contact contacts[kMaxGuidePoints];
  NearCapsule near[kMaxCapsules];
  NearPlane planes[kMaxPlanes];
  NearMesh meshes[kMaxMeshes];
};

// Unit directions of the links.
template <class Points>
HWY_INLINE void findDirections(std::uint32_t points, const Points* x, Vec3* directions) {
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Vec3 e = Vec3(x[i + 1]) - Vec3(x[i]);
    directions[i] = (Floats(1.0f) / max(length(e), Floats(1e-12f))) * e;
  }
}

// Distance from the head at which the air moves with half its speed.
inline constexpr float kCarriedAirRadius = 0.3f;

HWY_NOINLINE void addWind(const WindField& wind, const Vec3& p, const Lanes* share, Vec3& air) {
  const Vec3 blown = blow(wind, p);
  air = air + (share ? Floats(*share) * blown : blown);
}

// Predict: x = position after time h at the current velocity; force = all forces but bending, per
// linear density.
HWY_INLINE void predict(const Group& g, const GuideSettings& settings, const WindField* wind,
                        float h, const SubstepColliders& colliders, Scratch& s) {
  const float keep = 1.0f / (1.0f + settings.airDrag * h);
  // Find the head's velocity field. A point p carried by the head was at back · (p - now) + then a
  // time h ago, so its velocity is carry · (p - now) + drift.
  const glm::mat3 back = colliders.turnBefore * glm::transpose(colliders.turn);
  const glm::mat3 carry = (glm::mat3(1) - back) * (1.0f / h);
  const Vec3 drift((colliders.at - colliders.atBefore) * (1.0f / h)), now(colliders.at);
  const Vec3 gravity(settings.gravity);
  constexpr float kPerRadius2 = 1.0f / (kCarriedAirRadius * kCarriedAirRadius);
  // Apply the last tension along the last directions, clamped to what the bending system holds
  // (BendingFactors); the Newton iterations find the rest.
  if (g.hasUnevenLinks) scaleTensions(g);
  const auto pullOf = [&](std::uint32_t i) HWY_ATTR {
    const Floats tension =
        max(min(Floats(g.tension[i]), g.mostTension[i]), -Floats(g.mostCompression[i]));
    store(tension, g.tension[i]);
    return tension * s.directions[i];
  };
  Vec3 pull = pullOf(0);
  for (std::uint32_t i = 1; i < g.points; ++i) {
    // Let the air move with the head near it, and with the wind.
    const Vec3 p = g.position[i], fromHead = p - now;
    const Floats share = Floats(settings.carriedAir) /
                         (Floats(1.0f) + Floats(kPerRadius2) * dot(fromHead, fromHead));
    Vec3 air = share * (rotate(carry, fromHead) + drift);
    if (wind) addWind(*wind, p, g.windShare ? g.windShare + i : nullptr, air);
    // Sum gravity, the pull of the air and the push.
    Vec3 acceleration = gravity + Floats(keep * settings.airDrag) * air;
    if (g.push) acceleration = acceleration + Vec3(g.push[i]);
    // Move by the velocity with implicit drag, v' = (v + h drag · air) / (1 + h drag); its second
    // term is in the force.
    s.x[i] = p + Floats(h * keep) * Vec3(g.velocity[i]);
    // Add the tensions of the links on both sides.
    Vec3 force = Floats(g.mass[i]) * acceleration - pull;
    if (i + 1 < g.points) pull = pullOf(i), force = force + pull;
    s.force[i] = force;
  }
}

// Contacts: find the plane of the nearest capsule or of the head for each point. Skip points whose
// clearance, a lower bound of their distance to all of these, says that none is near.
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

// Contacts with scenery: replace a point's plane where a Plane or a mesh is nearer.
HWY_NOINLINE NearScenery findSceneryPlanes(const Group& g, float skin,
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

// Project points that penetrate their planes onto them, with friction.
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

// Recheck: find the planes again for points that the links moved farther than the collider they
// were near. True if one penetrates a collider. The skin is a safety margin; here, where a point
// may be between two colliders, a third of it is enough.
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

// Links, directly: bring links to their lengths and keep points out of their planes.
HWY_INLINE void solveLinks(const Group& g, const GuideSettings& settings, Scratch& s) {
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    pushOut(g, settings.friction, s);
    correctLinks(g.points, g.linkLength, g.inverseMass, s.contacts, s.lambda, s.x);
  }
  finishLinks(g.points, g.linkLength, g.bending.inverseLength, s.contacts, s.x, s.directions);
}

// Links, by relaxation. Keep the remaining stretch: restoring the lengths as finishLinks does would
// remove the momentum of what the sweeps have not corrected.
HWY_NOINLINE void relax(const Group& g, const GuideSettings& settings, Scratch& s) {
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    pushOut(g, settings.friction, s);
    relaxLinks(g.points, g.linkLength, g.inverseMass, s.contacts, s.x);
  }
  pushOut(g, settings.friction, s);
  findDirections(g.points, s.x, s.directions);
}

void substep(const Group& g, const GuideSettings& settings, const WindField* wind, float h,
             const SubstepColliders& colliders, Scratch& s) {
  const std::uint32_t n = g.points, links = n - 1;
  const bool direct = settings.linkSolver == LinkSolver::Direct;
  // Predict, then pin the root, and other points in the lanes where they are tied.
  predict(g, settings, wind, h, colliders, s);
  for (std::uint32_t i = 0; i < g.tied; ++i) {
    const Vec3 onHead = rotate(colliders.turn, g.restPosition[i]) + Vec3(colliders.at);
    s.x[i] = i == 0 ? onHead : select(Floats(g.inverseMass[i]) > Floats(0.0f), s.x[i], onHead);
  }
  // Bend, from the frames of the roots before and after.
  const RootFrame root{rotate(colliders.turn, g.rest.tangent),
                       rotate(colliders.turn, g.rest.normal)};
  const RootFrame rootBefore{rotate(colliders.turnBefore, g.rest.tangent),
                             rotate(colliders.turnBefore, g.rest.normal)};
  solveBending(g.bending, root, rootBefore, s.directions, s.force, s.x);

  // Find a contact plane for each point.
  const Near near = findNear(n, s.x, colliders);
  Surroundings around{colliders, {}, kSight, false};
  findPlanes(g, settings.skin, near, around, s);
  NearScenery scenery;
  if (!colliders.planes.empty() || !colliders.meshes.empty())
    scenery = findSceneryPlanes(g, settings.skin, colliders, s);
  // Solve the links, and again while rechecked points penetrate another collider.
  for (std::uint32_t i = 0; i < links; ++i) s.lambda[i] = 0.0f;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    if (direct)
      solveLinks(g, settings, s);
    else
      relax(g, settings, s);
    if (!recheckContacts(g, settings.skin, near.capsules, around, scenery, s)) break;
  }

  // Update the tension for the next substep. Relaxation leaves lambda 0 and so the tension of the
  // rest shape, which holds the groom: what unconverged sweeps would feed back makes links swing.
  const Floats perStep = 1.0f / h, perStep2 = 1.0f / (h * h);
  for (std::uint32_t i = 0; i < links; ++i) {
    Floats tension = Floats(g.tension[i]) - perStep2 * s.lambda[i];
    // Clear it between two tied points, where it is undefined and has no effect.
    if (i + 1 < g.tied)
      tension = select(Floats(g.inverseMass[i + 1]) > Floats(0.0f), tension, Floats(0.0f));
    store(tension, g.tension[i]);
  }
  // Take the velocity from the movement.
  for (std::uint32_t i = 0; i < n; ++i) {
    store(perStep * (s.x[i] - Vec3(g.position[i])), g.velocity[i]);
    store(s.x[i], g.position[i]);
  }
}

// Run all substeps of one group before those of the next: its state stays in the L1 cache.
void stepGroups(const GuideMotion& motion, const GuideSettings& settings, float h,
                const GuideWorkspace& workspace, std::size_t begin, std::size_t end,
                GuideStrands& guides) {
  const std::uint32_t n = guides.pointsPerGuide(), links = n - 1;
  const BendingFactors& factors = workspace.bending;
  Scratch s;
  s.contacts[0].near = s.contacts[0].touched = false;
  for (std::size_t k = begin; k < end; ++k) {
    const std::size_t p = k * n, l = k * links;
    const Group group{
        n,
        guides.tied[k],
        &guides.position[p],
        &guides.velocity[p],
        &guides.tension[l],
        &guides.restPosition[p],
        motion.push.empty() ? nullptr : &motion.push[p],
        motion.windShare.empty() ? nullptr : &motion.windShare[p],
        &guides.pointMass[p],
        &guides.inverseMass[p],
        &guides.linkLength[l],
        &factors.mostTension[l],
        &factors.mostCompression[l],
        &guides.clearance[p],
        {guides.rootTangent[k], guides.rootNormal[k]},
        {n, &guides.curvature[l], &guides.jointStiffness[l], &guides.inverseLength[l],
         &factors.inverseD[p], &factors.below1[p], &factors.below2[p], factors.damping},
        guides.hasUnevenLinks[k] != 0};
    findDirections(n, group.position, s.directions);
    for (std::uint32_t i = 0; i < n; ++i)
      s.queriedAt[i] = group.position[i], s.clear[i] = Clearance(0);
    for (std::size_t i = 0; i < workspace.colliders.size(); ++i)
      substep(group, settings, workspace.winds.empty() ? nullptr : &workspace.winds[i], h,
              workspace.colliders[i], s);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/guides/substeps.h>
#include <libhair/guides/validate.h>

namespace hair {

namespace {

HWY_EXPORT(stepGroups);

void shift(GuideStrands& guides, glm::vec3 by) {
  if (by == glm::vec3(0)) return;
  for (LaneVec3& p : guides.position) p = {p.x + by.x, p.y + by.y, p.z + by.z};
}

// Interpolate head and colliders at the ends of all substeps, relative to `origin`.
void cutFrame(const GuideMotion& motion, glm::vec3 origin, RigidTransform from, float skin,
              std::size_t substeps, GuideWorkspace& workspace) {
  RigidTransform to = motion.worldFromHead;
  from.translation -= origin, to.translation -= origin;
  const std::size_t capsules = motion.capsules.size();
  const std::size_t boxes = (capsules + kLanes - 1) / kLanes;
  workspace.heads.resize(substeps + 1);
  workspace.capsules.resize((substeps + 1) * capsules);
  workspace.boxes.clear();
  for (std::size_t s = 0; s <= substeps; ++s) {
    const float t = static_cast<float>(s) / static_cast<float>(substeps);
    workspace.heads[s] = blend(from, to, t);
    for (std::size_t c = 0; c < capsules; ++c) {
      const Capsule &before = motion.capsulesBefore[c], &after = motion.capsules[c];
      workspace.capsules[s * capsules + c] = {glm::mix(before.a - origin, after.a - origin, t),
                                              glm::mix(before.b - origin, after.b - origin, t),
                                              glm::mix(before.radius, after.radius, t)};
    }
    const std::span all(workspace.capsules);
    appendBoxes(all.subspan(s * capsules, capsules),
                all.subspan((s > 0 ? s - 1 : s) * capsules, capsules), skin + kSight,
                workspace.boxes);
  }
  const std::size_t planes = motion.scenery.planes.size(), meshes = motion.scenery.meshes.size();
  cutScenery(motion.sceneryBefore, motion.scenery, origin, substeps, workspace.planes,
             workspace.meshes);
  workspace.colliders.clear();
  for (std::size_t s = 1; s <= substeps; ++s)
    workspace.colliders.push_back(
        {glm::mat3_cast(workspace.heads[s].rotation),
         glm::mat3_cast(workspace.heads[s - 1].rotation), workspace.heads[s].translation,
         workspace.heads[s - 1].translation,
         std::span(workspace.capsules).subspan(s * capsules, capsules),
         std::span(workspace.capsules).subspan((s - 1) * capsules, capsules),
         std::span(workspace.boxes).subspan(s * boxes, boxes), motion.head,
         std::span(workspace.planes).subspan((s - 1) * planes, planes),
         std::span(workspace.meshes).subspan((s - 1) * meshes, meshes)});
}

}  // namespace

void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& workspace, GuideStrands& guides) {
  // Refuse input that a kernel could only turn into NaN.
  require(seconds >= 1e-6f && seconds <= 1, "stepGuides: a frame of ", seconds,
          " s is not in [1e-6, 1]; cut longer times into frames");
  validate(settings);
  validate(motion.worldFromHead);
  requirePrecision(guides, motion.worldFromHead);
  validate(motion.capsulesBefore);
  validate(motion.capsules);
  validatePush(motion.push);
  validate(motion.wind);
  require(motion.windShare.empty() || motion.windShare.size() == guides.position.size(),
          "stepGuides: ", motion.windShare.size(), " shares of the wind for ",
          guides.position.size(), " groups of points");
  require(motion.push.empty() || motion.push.size() == guides.position.size(),
          "stepGuides: ", motion.push.size(), " pushes for ", guides.position.size(),
          " groups of points");
  const std::size_t capsules = motion.capsules.size();
  require(capsules == motion.capsulesBefore.size() && capsules <= kMaxCapsules,
          "stepGuides: ", motion.capsulesBefore.size(), " capsules before and ", capsules,
          " after; they must be as many, at most ", kMaxCapsules);
  // Choose the substep, and factor the bending system for it.
  const float longest = longestSubstep(motion, settings, seconds, guides);
  const auto substeps =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(seconds / longest - 1e-3f)));
  const float h = seconds / static_cast<float>(substeps);
  const float weight = glm::length(settings.gravity) / std::max(guides.restGravity(), 1e-3f);
  factorBending(guides, h, settings.bendDamping, std::max(weight, 1.0f), workspace.bending);
  // Cut the frame into substeps.
  const glm::vec3 origin = stepOrigin(motion.worldFromHead);
  cutFrame(motion, origin, guides.worldFromHead, settings.skin, substeps, workspace);
  workspace.winds.clear();
  for (std::size_t s = 0; s < substeps && !motion.wind.still(); ++s)
    workspace.winds.push_back(
        motion.wind.at(motion.time + static_cast<double>(s) * double{h}).seenFrom(origin));
  // Step near the origin, where floats are fine enough.
  shift(guides, -origin);
  parallelFor(guides.groupCount(), 1, [&](std::size_t begin, std::size_t end) {
    HWY_DYNAMIC_DISPATCH(stepGroups)(motion, settings, h, workspace, begin, end, guides);
  });
  shift(guides, origin);
  guides.worldFromHead = motion.worldFromHead;
}

}  // namespace hair

#endif

// One substep of length h, of sixteen strands ("a group") at once; point 0 is the root:
//
//      position, velocity, tension
//        |  predict    x = position + h velocity,
//        |             force = gravity, air, push, tension                    predict-inl.h
//        |  pin        put the root and tied points on the head
//        |  bend       x += (M / h² + K)⁻¹ (force - grad E(x))                bending-inl.h
//        |  contacts   find the nearest collider's plane, n · x >= offset     group_contacts-inl.h
//    .-> |  links      push x out of the planes, solve |x_(i+1) - x_i| = l_i  links-inl.h
//    '-- |  recheck    find new planes for points that the links moved far    group_contacts-inl.h
//        v
//      velocity = (x - position) / h,   tension -= lambda / h²
//
// stepGuides, at the end, cuts a frame into substeps and runs those of a group on one thread.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/guides/step.cpp"
#include <hwy/foreach_target.h>
#include <libhair/guides/bending-inl.h>
#include <libhair/guides/group-inl.h>
#include <libhair/guides/group_contacts-inl.h>
#include <libhair/guides/links-inl.h>
#include <libhair/guides/predict-inl.h>
#include <libhair/guides/relaxation-inl.h>

#include <libhair/guides/guide_strands.h>
#include <libhair/guides/substep_memory.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

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
                const SubstepMemory& workspace, std::size_t begin, std::size_t end,
                GuideStrands& guides) {
  const std::uint32_t n = guides.pointsPerGuide(), links = n - 1;
  const BendingFactors& factors = workspace.bending;
  Scratch s;
  s.contacts[0].near = s.contacts[0].touched = false;
  for (std::size_t k = begin; k < end; ++k) {
    const std::size_t p = k * n, l = k * links;
    const Group group{
        .rest = {guides.rootTangent[k], guides.rootNormal[k]},
        .bending = {n, &guides.curvature[l], &guides.jointStiffness[l], &guides.inverseLength[l],
                    &factors.inverseD[p], &factors.below1[p], &factors.below2[p], factors.damping},
        .position = &guides.position[p],
        .velocity = &guides.velocity[p],
        .tension = &guides.tension[l],
        .restPosition = &guides.restPosition[p],
        .push = motion.push.empty() ? nullptr : &motion.push[p],
        .windShare = motion.windShare.empty() ? nullptr : &motion.windShare[p],
        .mass = &guides.pointMass[p],
        .inverseMass = &guides.inverseMass[p],
        .linkLength = &guides.linkLength[l],
        .mostTension = &factors.mostTension[l],
        .mostCompression = &factors.mostCompression[l],
        .clearance = &guides.clearance[p],
        .points = n,
        .tied = guides.tied[k],
        .hasUnevenLinks = guides.hasUnevenLinks[k] != 0};
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

}  // namespace

GuideWorkspace::GuideWorkspace() : memory_(std::make_unique<SubstepMemory>()) {}
GuideWorkspace::~GuideWorkspace() = default;
GuideWorkspace::GuideWorkspace(GuideWorkspace&&) noexcept = default;
GuideWorkspace& GuideWorkspace::operator=(GuideWorkspace&&) noexcept = default;

void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& kept, GuideStrands& guides) {
  SubstepMemory& workspace = kept.memory();
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

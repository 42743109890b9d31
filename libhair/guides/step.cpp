#include <libhair/guides/step.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/guides/contact.h>
#include <libhair/guides/links.h>

namespace hair {

namespace {

constexpr std::size_t kMaxCapsules = 64;

// Everything that one substep of one group reads, pointing into the group's part of the arrays.
struct Group {
  std::uint32_t points;
  float h;
  LaneVec3 *position, *velocity;
  Lanes* tension;
  const LaneVec3 *restPosition, *curvature, *push;
  const Lanes *mass, *linkLength, *jointStiffness, *clearance;
  const Lanes *inverseD, *below1, *below2;
  LaneVec3 rootTangent, rootNormal;
};

using PointArray = std::array<LaneVec3, kMaxGuidePoints>;

// Distance from the head at which the air moves with half its speed.
constexpr float kCarriedAirRadius = 0.3f;

// x = where its velocity alone takes every free point in time h; force = all that acts on it but
// bending, per linear density.
void predict(const Group& g, const GuideSettings& settings, const Wind& wind, double time,
             const ColliderState& colliders, PointArray& x, PointArray& force) {
  const float h = g.h, keep = 1.0f / (1.0f + settings.airDrag * h);
  const bool still = wind.still();
  // What moves with the head was, h ago, at back · (p - now) + then.
  const RigidTransform &now = colliders.worldFromHead, &then = colliders.worldFromHeadBefore;
  const glm::mat3 back = glm::mat3_cast(then.rotation * glm::conjugate(now.rotation));
  for (std::uint32_t i = 1; i < g.points; ++i) {
    const LaneVec3 p = g.position[i], fromHead = p - broadcast(now.translation);
    const LaneVec3 carried =
        fromHead - rotate(back, fromHead) + broadcast(now.translation - then.translation);
    const Lanes share = settings.carriedAir /
                        (1.0f + dot(fromHead, fromHead) / (kCarriedAirRadius * kCarriedAirRadius));
    LaneVec3 air = (1.0f / h * share) * carried;
    if (!still)
      for (std::size_t l = 0; l < kLanes; ++l)
        setLane(air, l, lane(air, l) + wind.at(lane(p, l), time));
    LaneVec3 acceleration = broadcast(settings.gravity) + lanes(keep * settings.airDrag) * air;
    if (g.push) acceleration = acceleration + g.push[i];
    // Implicit drag: v' = (v + h drag · air) / (1 + h drag), then what else accelerates.
    x[i] = p + lanes(h * keep) * g.velocity[i];
    force[i] = g.mass[i] * acceleration;
  }
  // Tension acts along the links as they were; beyond m l / (4 h²) it could no longer be stepped
  // explicitly, and Newton does the rest.
  force[0] = LaneVec3{};
  for (std::uint32_t i = 0; i + 1 < g.points; ++i) {
    const LaneVec3 d = (1.0f / g.linkLength[i]) * (g.position[i + 1] - g.position[i]);
    const Lanes most = 0.25f / (h * h) * g.mass[i + 1] * g.linkLength[i];
    g.tension[i] = max(min(g.tension[i], most), -most);
    force[i] = force[i] + g.tension[i] * d;
    force[i + 1] = force[i + 1] - g.tension[i] * d;
  }
}

// Coulomb: of the way along the surface, takes back as much as friction can for this push.
LaneVec3 rub(LaneVec3 x, LaneVec3 before, const ContactPlane& plane, Lanes depth, float friction) {
  const LaneVec3 moved = x - before - plane.surfaceMove;
  const LaneVec3 along = moved - dot(moved, plane.normal) * plane.normal;
  const Lanes way = length(along);
  const Lanes taken = min(lanes(friction) * depth, way) / max(way, lanes(1e-12f));
  return x - taken * along;
}

void substep(const Group& g, const GuideSettings& settings, const GuideMotion& motion, double time,
             const ColliderState& colliders) {
  const std::uint32_t n = g.points, links = n - 1;
  const float h = g.h;
  PointArray x, force, seenAt;
  std::array<Lanes, kMaxGuidePoints> inverseMass, lambda, way;
  std::array<ContactPlane, kMaxGuidePoints> planes;
  std::array<LaneMask, kMaxGuidePoints> touching;

  predict(g, settings, motion.wind, time, colliders, x, force);

  const glm::mat3 turn = glm::mat3_cast(colliders.worldFromHead.rotation);
  x[0] = rotate(turn, g.restPosition[0]) + broadcast(colliders.worldFromHead.translation);
  const glm::mat3 turnBefore = glm::mat3_cast(colliders.worldFromHeadBefore.rotation);
  solveBending({n, g.curvature, g.jointStiffness, g.linkLength, g.inverseD, g.below1, g.below2,
                settings.bendDamping / h},
               {rotate(turn, g.rootTangent), rotate(turn, g.rootNormal)},
               {rotate(turnBefore, g.rootTangent), rotate(turnBefore, g.rootNormal)}, g.position,
               force.data(), x.data());

  LaneVec3 anchors[kAnchoredPoints];
  for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
    anchors[i] = rotate(turn, g.restPosition[std::min(i + 1, links)]) +
                 broadcast(colliders.worldFromHead.translation);
  // Capsules that a box around the group touches.
  glm::vec3 lower(INFINITY), upper(-INFINITY);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::size_t l = 0; l < kLanes; ++l) {
      const glm::vec3 p(x[i].x[l], x[i].y[l], x[i].z[l]);
      lower = glm::min(lower, p), upper = glm::max(upper, p);
    }
  std::array<NearCapsule, kMaxCapsules> near;
  std::size_t nearCount = 0;
  for (std::size_t c = 0; c < colliders.capsules.size(); ++c) {
    const Capsule& capsule = colliders.capsules[c];
    const glm::vec3 reach(capsule.radius + settings.skin);
    if (glm::all(glm::lessThan(glm::min(capsule.a, capsule.b) - reach, upper)) &&
        glm::all(glm::lessThan(lower, glm::max(capsule.a, capsule.b) + reach)))
      near[nearCount++] = nearCapsule(capsule, colliders.capsulesBefore[c], anchors, settings.skin);
  }

  bool swallowed = false;
  for (std::size_t c = 0; c < nearCount; ++c)
    for (const Lanes& reach : near[c].reach) swallowed |= any(reach < near[c].full);
  const auto look = [&](std::uint32_t i, float slack, Clearance clearance) {
    seenAt[i] = x[i];
    planes[i] = nearestPlane(x[i], i, way[i], g.clearance[i], colliders, {near.data(), nearCount},
                             slack, clearance);
    return clearance;
  };
  planes[0] = ContactPlane{{}, lanes(-1e3f), {}, lanes(1e3f)};
  inverseMass[0] = Lanes{}, touching[0] = LaneMask{}, lambda[0] = Lanes{};
  Clearance known;
  for (std::uint32_t i = 1; i < n; ++i) {
    inverseMass[i] = 1.0f / g.mass[i];
    touching[i] = LaneMask{}, lambda[i] = Lanes{};
    way[i] = i > kAnchoredPoints ? way[i - 1] + g.linkLength[i - 1] : Lanes{};
    known.step(length(x[i] - x[i - 1]), swallowed);
    known = look(i, 0, known);
  }
  // Links drag points off; those that went farther than to the collider they saw must look again,
  // and if one is inside another collider by now, all is corrected again. The skin is for comfort:
  // a point pinched between two colliders has to do with a third of it.
  const float slack = settings.skin * (2.0f / 3.0f);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    for (int iteration = 0; iteration < settings.iterations; ++iteration) {
      for (std::uint32_t i = 1; i < n; ++i) {
        const Lanes depth = planes[i].offset - dot(planes[i].normal, x[i]);
        const LaneMask inside = depth > 0.0f;
        touching[i] |= inside;
        if (!any(inside)) continue;
        const Lanes push = inside ? depth : lanes(0);
        x[i] = x[i] + push * planes[i].normal;
        x[i] = rub(x[i], g.position[i], planes[i], push, settings.friction);
      }
      correctLinks(n, g.linkLength, inverseMass.data(), planes.data(), touching.data(),
                   lambda.data(), x.data());
    }
    finishLinks(n, g.linkLength, planes.data(), x.data());
    bool again = false;
    for (std::uint32_t i = 1; i < n; ++i) {
      if (!any(length(x[i] - seenAt[i]) > max(planes[i].distance, lanes(0)) + 0.5f * settings.skin))
        continue;
      look(i, slack, {});
      again |= any(planes[i].distance < 0.0f);
    }
    if (!again) break;
  }

  for (std::uint32_t i = 0; i < links; ++i) g.tension[i] = g.tension[i] - lambda[i] / (h * h);
  for (std::uint32_t i = 0; i < n; ++i) {
    g.velocity[i] = lanes(1.0f / h) * (x[i] - g.position[i]);
    g.position[i] = x[i];
  }
}

}  // namespace

void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& workspace, GuideStrands& guides) {
  require(seconds > 0 && seconds <= 1, "stepGuides: a frame of ", seconds,
          " s is not in (0, 1]; cut longer times into frames");
  validate(settings);
  require(motion.wind.valid(),
          "wind: velocity must be below 200 m/s, gust in [0, 1], gustLength > 0");
  require(motion.push.empty() || motion.push.size() == guides.position.size(),
          "stepGuides: ", motion.push.size(), " pushes for ", guides.position.size(),
          " groups of points");
  const std::size_t capsules = motion.capsules.size();
  require(capsules == motion.capsulesBefore.size() && capsules <= kMaxCapsules,
          "stepGuides: ", motion.capsulesBefore.size(), " capsules before and ", capsules,
          " after; they must be as many, at most ", kMaxCapsules);
  const auto substeps = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil(seconds / settings.substep - 1e-3f)));
  const float h = seconds / static_cast<float>(substeps);
  factorBending(guides, h, settings.bendDamping, workspace.bending);

  workspace.heads.resize(substeps + 1);
  workspace.capsules.resize((substeps + 1) * capsules);
  for (std::size_t s = 0; s <= substeps; ++s) {
    const float t = static_cast<float>(s) / static_cast<float>(substeps);
    workspace.heads[s] = blend(guides.worldFromHead, motion.worldFromHead, t);
    for (std::size_t c = 0; c < capsules; ++c) {
      const Capsule &from = motion.capsulesBefore[c], &to = motion.capsules[c];
      workspace.capsules[s * capsules + c] = {glm::mix(from.a, to.a, t), glm::mix(from.b, to.b, t),
                                              glm::mix(from.radius, to.radius, t)};
    }
  }

  const std::size_t n = guides.pointsPerGuide(), links = n - 1;
  parallelFor(guides.groupCount(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      // All substeps of a group in one go: its state stays in the first-level cache.
      const Group group{static_cast<std::uint32_t>(n),
                        h,
                        &guides.position[k * n],
                        &guides.velocity[k * n],
                        &guides.tension[k * links],
                        &guides.restPosition[k * n],
                        &guides.curvature[k * links],
                        motion.push.empty() ? nullptr : &motion.push[k * n],
                        &guides.pointMass[k * n],
                        &guides.linkLength[k * links],
                        &guides.jointStiffness[k * links],
                        &guides.clearance[k * n],
                        &workspace.bending.inverseD[k * n],
                        &workspace.bending.below1[k * n],
                        &workspace.bending.below2[k * n],
                        guides.rootTangent[k],
                        guides.rootNormal[k]};
      for (std::size_t s = 1; s <= substeps; ++s) {
        const ColliderState colliders{
            workspace.heads[s], workspace.heads[s - 1],
            std::span(workspace.capsules).subspan(s * capsules, capsules),
            std::span(workspace.capsules).subspan((s - 1) * capsules, capsules), motion.head};
        substep(group, settings, motion, motion.time + static_cast<double>(s - 1) * h, colliders);
      }
    }
  });
  guides.worldFromHead = motion.worldFromHead;
}

}  // namespace hair

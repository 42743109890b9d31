#include <libhair/guides/rest_shape.h>
#include <libhair/guides/substeps.h>

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

// The velocity of a head that moves evenly from one place to another.
struct HeadMotion {
  glm::vec3 drift, spin;  // m/s, rad/s

  HeadMotion(const RigidTransform& from, const RigidTransform& to, float seconds)
      : drift((to.translation - from.translation) / seconds) {
    const glm::quat turn = to.rotation * glm::conjugate(from.rotation);
    const glm::vec3 axis =
        turn.w < 0 ? -glm::vec3(turn.x, turn.y, turn.z) : glm::vec3(turn.x, turn.y, turn.z);
    const float sine = glm::length(axis);
    const float angle = 2 * std::atan2(sine, std::abs(turn.w));
    spin = angle / (seconds * std::max(sine, 1e-12f)) * axis;
  }
};

// The load on the hair in this frame, over its weight at rest.
float pullOf(const GuideMotion& motion, const GuideSettings& settings, const HeadMotion& head,
             const GuideStrands& guides) {
  const float spin = glm::length(head.spin), reach = guides.reach();
  // Add the speeds of wind (gusts double it) and head.
  const float speed =
      2 * glm::length(motion.wind.velocity) + glm::length(head.drift) + spin * reach;
  const float most = glm::length(settings.gravity) + settings.airDrag * speed + spin * spin * reach;
  return std::max(1.0f, most / std::max(guides.restGravity(), 1e-3f));
}

// The longest substep in which no root leaves its predicted path by more than half a link: because
// its velocity differs from the last one, or because it moves on a circle.
float longestForRoots(const HeadMotion& head, const GuideStrands& guides) {
  const std::size_t n = guides.pointsPerGuide();
  float change = 0;
  for (std::size_t g = 0; g < guides.guideCount(); ++g) {
    const std::size_t group = g / kLanes, l = g % kLanes;
    const glm::vec3 arm = guides.worldFromHead.vector(lane(guides.restPosition[group * n], l));
    const glm::vec3 velocity = head.drift + glm::cross(head.spin, arm);
    change = std::max(change, glm::distance(velocity, lane(guides.velocity[group * n], l)));
  }
  const float half = 0.5f * guides.shortestLink();
  const float round = glm::dot(head.spin, head.spin) * guides.reach();
  return std::max(kShortestSubstep, std::min(half / std::max(change, 1e-9f),
                                             std::sqrt(half / std::max(round, 1e-9f))));
}

}  // namespace

float longestSubstep(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                     const GuideStrands& guides) {
  const HeadMotion head(guides.worldFromHead, motion.worldFromHead, seconds);
  const float pull = pullOf(motion, settings, head, guides);
  return std::min({settings.substep, guides.longestSubstep(motion.worldFromHead, pull),
                   longestForRoots(head, guides)});
}

void cutFrame(const GuideMotion& motion, glm::vec3 origin, RigidTransform from, float skin,
              std::size_t substeps, SubstepMemory& workspace) {
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

}  // namespace hair

#include <libhair/simulation/frame.h>

#include <algorithm>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/guides/validate.h>
#include <libhair/simulation/collider_fade_in.h>
#include <libhair/simulation/stages.h>

namespace hair {

namespace {

// Substeps in which colliders grow to full size. A trunk grows by a few millimetres in each, which
// the solver handles as body motion.
constexpr int kPlacingSteps = 24;

// Rotates about the head, which keeps distances precise far from the origin.
struct Jump {
  glm::quat turn;
  glm::vec3 from, to;

  glm::vec3 point(glm::vec3 p) const { return turn * (p - from) + to; }
  glm::vec3 vector(glm::vec3 v) const { return turn * v; }
};

template <class Move>
void moveAll(std::vector<LaneVec3>& values, Move&& move) {
  for (LaneVec3& v : values)
    for (std::size_t l = 0; l < kLanes; ++l) setLane(v, l, move(lane(v, l)));
}

// Applies `point` to all positions except planes and meshes, and sets the head's pose.
template <class Move>
void movePlaces(const RigidTransform& worldFromHead, Move&& point, Hair& hair) {
  moveAll(hair.guides.position, point);
  for (glm::vec3& p : hair.wisps.points) p = point(p);
  for (Capsule& c : hair.capsules) c.a = point(c.a), c.b = point(c.b);
  hair.worldFromHead = hair.guides.worldFromHead = worldFromHead;
}

// Marks guides with a point inside a collider or in the inner half of its skin. A point in resting
// contact is farther out.
std::vector<LaneMask> caught(const GuideStrands& guides, const BodyState& body, const MeshSdf* head,
                             float skin) {
  const std::uint32_t n = guides.pointsPerGuide();
  const RigidTransform headFromWorld = inverse(guides.worldFromHead);
  const auto in = [&](glm::vec3 p, float clearance) {
    if (head && head->distance(headFromWorld.point(p)) < clearance - 0.5f * skin) return true;
    const auto close = [&](const auto& collider) {
      return distanceAndGradient(collider, p).w < 0.5f * skin;
    };
    return std::ranges::any_of(body.capsules, close) ||
           std::ranges::any_of(body.scenery.planes, close) ||
           std::ranges::any_of(body.scenery.meshes, close);
  };
  std::vector<LaneMask> inside(guides.groupCount());
  for (std::size_t at = 0; at < guides.position.size(); ++at)
    for (std::size_t l = 0; l < kLanes && at % n > 0; ++l)
      if (in(lane(guides.position[at], l), guides.clearance[at][l])) inside[at / n][l] = -1;
  return inside;
}

// Moves guides out of the body by growing its colliders. Time, velocities and tensions stay.
void bringOut(const BodyState& body, const GuideSettings& settings, const MeshSdf* head,
              GuideWorkspace& workspace, GuideStrands& guides) {
  const std::vector<LaneMask> inside = caught(guides, body, head, settings.skin);
  if (std::ranges::none_of(inside, [](const LaneMask& m) {
        for (std::size_t l = 0; l < kLanes; ++l)
          if (m[l]) return true;
        return false;
      }))
    return;
  const GuideStrands before = guides;
  ColliderFadeIn growing(body, guides), smaller(body, guides);
  for (int step = 1; step <= kPlacingSteps; ++step) {
    const BodyState from = smaller.at(static_cast<float>(step - 1) / kPlacingSteps),
                    to = growing.at(static_cast<float>(step) / kPlacingSteps);
    std::ranges::fill(guides.velocity, LaneVec3{});
    guides.tension = before.tension;
    GuideMotion motion{guides.worldFromHead, to.capsules, from.capsules, head};
    motion.scenery = to.scenery, motion.sceneryBefore = from.scenery;
    stepGuides(motion, settings, settings.substep, workspace, guides);
  }
  guides.velocity = before.velocity;
  guides.tension = before.tension;
  const std::uint32_t n = guides.pointsPerGuide();
  for (std::size_t at = 0; at < guides.position.size(); ++at)
    for (std::size_t l = 0; l < kLanes; ++l)
      if (!inside[at / n][l]) setLane(guides.position[at], l, lane(before.position[at], l));
}

// Copies link directions, velocities and tensions from guides with equal counts.
void takeMotion(const GuideStrands& from, GuideStrands& to) {
  const std::uint32_t n = to.pointsPerGuide();
  to.velocity = from.velocity;
  to.tension = from.tension;
  for (std::size_t at = 0; at < to.position.size(); ++at) {
    if (at % n == 0) continue;
    const std::size_t link = at / n * (n - 1) + at % n - 1;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const glm::vec3 way = lane(from.position[at], l) - lane(from.position[at - 1], l);
      setLane(to.position[at], l,
              lane(to.position[at - 1], l) +
                  (to.linkLength[link][l] / std::max(glm::length(way), 1e-9f)) * way);
    }
  }
}

}  // namespace

void teleport(const RigidTransform& worldFromHead, Hair& hair) {
  validate(worldFromHead);
  requirePrecision(hair.guides, worldFromHead);
  const RigidTransform& old = hair.worldFromHead;
  const Jump jump{glm::normalize(worldFromHead.rotation * glm::conjugate(old.rotation)),
                  old.translation, worldFromHead.translation};
  const auto vector = [&](glm::vec3 v) { return jump.vector(v); };
  moveAll(hair.guides.velocity, vector);
  moveAll(hair.repulsion.push, vector);
  movePlaces(worldFromHead, [&](glm::vec3 p) { return jump.point(p); }, hair);
  // Scenery may or may not move with the head: forget it, so that the next frame takes it as at
  // rest.
  hair.planes.clear(), hair.meshes.clear();
}

void moveOrigin(glm::vec3 origin, Hair& hair) {
  RigidTransform worldFromHead = hair.worldFromHead;
  worldFromHead.translation -= origin;
  validate(worldFromHead);
  requirePrecision(hair.guides, worldFromHead);
  movePlaces(worldFromHead, [&](glm::vec3 p) { return p - origin; }, hair);
  for (Plane& plane : hair.planes) plane.point -= origin;
  for (MeshCollider& mesh : hair.meshes) mesh.worldFromMesh.translation -= origin;
}

void changeColliders(const BodyState& body, const FrameSettings& settings, Hair& hair) {
  require(body.capsules.size() <= kMaxCapsules, "changeColliders: ", body.capsules.size(),
          " capsules; take at most ", kMaxCapsules);
  validate(body.capsules);
  validate(body.scenery);
  bringOut(body, settings.guides, hair.head, HairScratch::guides(hair), hair.guides);
  hair.remember({hair.worldFromHead, body.capsules, body.scenery});
}

bool changeGroom(const Groom& groom, const FrameSettings& settings, Hair& hair) {
  const BodyState body = hair.body();
  Hair next(groom, settings, body, hair.head, hair.wisps.settings);
  next.time = hair.time;
  const bool goesOn = next.guides.guideCount() == hair.guides.guideCount() &&
                      next.guides.pointsPerGuide() == hair.guides.pointsPerGuide();
  if (goesOn) {
    takeMotion(hair.guides, next.guides);
    if (next.repulsion.push.size() == hair.repulsion.push.size()) {
      next.repulsion.push = hair.repulsion.push;
      next.repulsion.turn = hair.repulsion.turn;
      next.repulsion.waiting = hair.repulsion.waiting;
      next.repulsion.windShare = hair.repulsion.windShare;
    }
  }
  bringOut(body, settings.guides, next.head, HairScratch::guides(next), next.guides);
  interpolateWisps(next.guides, collidersOf(body, next.head), next.wisps);
  hair = std::move(next);
  return goesOn;
}

}  // namespace hair

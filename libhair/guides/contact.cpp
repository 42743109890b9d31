#include <libhair/guides/contact.h>

#include <algorithm>

#include <libhair/model/mesh_sdf.h>

namespace hair {

namespace {

// Farther than anything reaches in a substep.
constexpr float kFar = 1e3f;
// Farther than most points go in a substep: those that do look again (stepGuides).
constexpr float kFarEnough = 0.01f;

// Where the axis of a capsule is nearest to points: a + t · axis.
struct Foot {
  Lanes t;
  LaneVec3 point;
};

Foot footOf(const Capsule& c, LaneVec3 p) {
  const glm::vec3 axis = c.b - c.a;
  const float axis2 = glm::dot(axis, axis);
  const LaneVec3 a = broadcast(c.a), ab = broadcast(axis);
  Lanes t = dot(p - a, ab) * (axis2 > 0 ? 1.0f / axis2 : 0.0f);
  t = min(max(t, lanes(0)), lanes(1));
  return {t, a + t * ab};
}

// Keeps in `best` the plane of a capsule where that is nearer than what it holds.
void nearerCapsule(LaneVec3 p, const NearCapsule& capsule, Lanes reach, ContactPlane& best) {
  const Foot foot = footOf(*capsule.now, p);
  const LaneVec3 out = p - foot.point;
  // Most capsules are farther than what is held already: no root is needed to see that.
  const Lanes length2 = dot(out, out), within = best.distance + reach;
  if (!any(length2 < within * within)) return;
  const Lanes r = sqrt(length2), d = r - reach;
  const LaneMask nearer = d < best.distance;
  if (!any(nearer)) return;
  const LaneVec3 normal = (1.0f / max(r, lanes(1e-9f))) * out;
  const glm::vec3 moveA = capsule.now->a - capsule.before->a;
  const glm::vec3 moveB = capsule.now->b - capsule.before->b;
  const LaneVec3 move = broadcast(moveA) + foot.t * broadcast(moveB - moveA);
  best.normal = select(nearer, normal, best.normal);
  best.offset = nearer ? dot(normal, foot.point) + reach : best.offset;
  best.surfaceMove = select(nearer, move, best.surfaceMove);
  best.distance = nearer ? d : best.distance;
}

// The same for the head, in the lanes that may be near it; `known` is made exact.
void nearerHead(LaneVec3 p, Lanes keep, const ColliderState& colliders, Lanes& known,
                ContactPlane& best) {
  const glm::mat3 worldFromHead = glm::mat3_cast(colliders.worldFromHead.rotation);
  for (std::size_t l = 0; l < kLanes; ++l) {
    if (known[l] > kFarEnough) {
      best.distance[l] = std::min(best.distance[l], known[l]);
      continue;
    }
    const glm::vec3 world = lane(p, l);
    const glm::vec3 local = (world - colliders.worldFromHead.translation) * worldFromHead;
    const float bound = colliders.head->lowerBound(local) - keep[l];
    const float d = bound > kFarEnough ? bound : colliders.head->distance(local) - keep[l];
    known[l] = d;
    if (!(d < best.distance[l])) continue;
    best.distance[l] = d;
    if (d > kFarEnough) {
      best.offset[l] = -kFar;
      continue;
    }
    const glm::vec3 normal = worldFromHead * glm::vec3(colliders.head->distanceAndGradient(local));
    setLane(best.normal, l, normal);
    setLane(best.surfaceMove, l, world - colliders.worldFromHeadBefore.point(local));
    best.offset[l] = glm::dot(normal, world) - d;
  }
}

}  // namespace

NearCapsule nearCapsule(const Capsule& now, const Capsule& before, const LaneVec3* anchors,
                        float skin) {
  NearCapsule near{&now, &before, {}, now.radius + skin};
  for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
    near.reach[i] =
        min(length(anchors[i] - footOf(now, anchors[i]).point) + 0.5f * skin, lanes(near.full));
  return near;
}

ContactPlane nearestPlane(LaneVec3 points, std::uint32_t index, Lanes way, Lanes headClearance,
                          const ColliderState& colliders, std::span<const NearCapsule> near,
                          float slack, Clearance& clearance) {
  ContactPlane best{{}, lanes(-kFar), {}, lanes(kFar)};
  if (any(clearance.body < kFarEnough)) {
    for (const NearCapsule& capsule : near)
      nearerCapsule(points, capsule, capsule.reachOf(index, way) - slack, best);
    clearance.body = best.distance;
  } else {
    best.distance = clearance.body;
  }
  if (colliders.head) nearerHead(points, headClearance - slack, colliders, clearance.head, best);
  return best;
}

}  // namespace hair

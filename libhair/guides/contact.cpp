#include <libhair/guides/contact.h>

#include <libhair/model/mesh_sdf.h>

namespace hair {

namespace {

// Farther than anything reaches in a substep.
constexpr float kFar = 1e3f;

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
  const Lanes r = length(out), d = r - reach;
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

void nearerHead(LaneVec3 p, Lanes clearance, const ColliderState& colliders, ContactPlane& best) {
  const glm::mat3 worldFromHead = glm::mat3_cast(colliders.worldFromHead.rotation);
  const glm::mat3 headFromWorld = glm::transpose(worldFromHead);
  for (std::size_t l = 0; l < kLanes; ++l) {
    const glm::vec3 world(p.x[l], p.y[l], p.z[l]);
    const glm::vec3 local = headFromWorld * (world - colliders.worldFromHead.translation);
    const glm::vec4 field = colliders.head->distanceAndGradient(local);
    const float d = field.w - clearance[l];
    if (!(d < best.distance[l])) continue;
    const glm::vec3 normal = worldFromHead * glm::vec3(field);
    const glm::vec3 move = world - colliders.worldFromHeadBefore.point(local);
    best.distance[l] = d;
    best.normal.x[l] = normal.x, best.normal.y[l] = normal.y, best.normal.z[l] = normal.z;
    best.offset[l] = glm::dot(normal, world) - d;
    best.surfaceMove.x[l] = move.x, best.surfaceMove.y[l] = move.y, best.surfaceMove.z[l] = move.z;
  }
}

}  // namespace

NearCapsule nearCapsule(const Capsule& now, const Capsule& before, const LaneVec3* anchors,
                        float skin) {
  NearCapsule near{&now, &before, {}, now.radius + skin};
  for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
    near.reach[i] = min(length(anchors[i] - footOf(now, anchors[i]).point), lanes(near.full));
  return near;
}

ContactPlane nearestPlane(LaneVec3 points, std::uint32_t index, Lanes way, Lanes headClearance,
                          const ColliderState& colliders, std::span<const NearCapsule> near) {
  ContactPlane best{{}, lanes(-kFar), {}, lanes(kFar)};
  for (const NearCapsule& capsule : near)
    nearerCapsule(points, capsule, capsule.reachOf(index, way), best);
  if (colliders.head) nearerHead(points, headClearance, colliders, best);
  return best;
}

}  // namespace hair

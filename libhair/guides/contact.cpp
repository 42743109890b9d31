#include <libhair/guides/contact.h>

#include <libhair/model/mesh_sdf.h>

namespace hair {

namespace {

// Farther than anything reaches in a substep.
constexpr float kFar = 1e3f;

// Keeps in `best` the plane of capsule `c` where that is nearer than `distance` so far.
void nearerCapsule(LaneVec3 p, float skin, const Capsule& c, const Capsule& before, Lanes& distance,
                   ContactPlane& best) {
  const glm::vec3 axis = c.b - c.a;
  const float axis2 = glm::dot(axis, axis);
  const LaneVec3 a = broadcast(c.a), ab = broadcast(axis);
  Lanes t = dot(p - a, ab) * (axis2 > 0 ? 1.0f / axis2 : 0.0f);
  t = min(max(t, lanes(0)), lanes(1));
  const LaneVec3 foot = a + t * ab, out = p - foot;
  const Lanes length2 = dot(out, out), r = sqrt(length2);
  const Lanes d = r - (c.radius + skin);
  const LaneMask nearer = d < distance;
  if (!any(nearer)) return;
  const LaneVec3 normal = (1.0f / max(r, lanes(1e-9f))) * out;
  const LaneVec3 move =
      broadcast(c.a - before.a) + t * broadcast((c.b - before.b) - (c.a - before.a));
  best.normal = select(nearer, normal, best.normal);
  best.offset = nearer ? dot(normal, foot) + (c.radius + skin) : best.offset;
  best.surfaceMove = select(nearer, move, best.surfaceMove);
  distance = nearer ? d : distance;
}

void nearerHead(LaneVec3 p, Lanes clearance, const ColliderState& colliders, Lanes& distance,
                ContactPlane& best) {
  const glm::mat3 worldFromHead = glm::mat3_cast(colliders.worldFromHead.rotation);
  const glm::mat3 headFromWorld = glm::transpose(worldFromHead);
  for (std::size_t l = 0; l < kLanes; ++l) {
    const glm::vec3 world(p.x[l], p.y[l], p.z[l]);
    const glm::vec3 local = headFromWorld * (world - colliders.worldFromHead.translation);
    const glm::vec4 field = colliders.head->distanceAndGradient(local);
    const float d = field.w - clearance[l];
    if (!(d < distance[l])) continue;
    const glm::vec3 normal = worldFromHead * glm::vec3(field);
    const glm::vec3 move = world - colliders.worldFromHeadBefore.point(local);
    distance[l] = d;
    best.normal.x[l] = normal.x, best.normal.y[l] = normal.y, best.normal.z[l] = normal.z;
    best.offset[l] = glm::dot(normal, world) - d;
    best.surfaceMove.x[l] = move.x, best.surfaceMove.y[l] = move.y, best.surfaceMove.z[l] = move.z;
  }
}

}  // namespace

ContactPlane nearestPlane(LaneVec3 points, Lanes headClearance, float skin,
                          const ColliderState& colliders, std::span<const std::uint16_t> near) {
  ContactPlane best{{}, lanes(-kFar), {}};
  Lanes distance = lanes(kFar);
  for (std::uint16_t c : near)
    nearerCapsule(points, skin, colliders.capsules[c], colliders.capsulesBefore[c], distance, best);
  if (colliders.head) nearerHead(points, headClearance, colliders, distance, best);
  return best;
}

}  // namespace hair

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/wisps/obstacles.cpp"
#include <hwy/foreach_target.h>
#include <libhair/wisps/obstacles-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// Metres; more than positions some metres from the origin are rounded by.
constexpr float kSlack = 1e-5f;

// Broad phase: finds the capsules whose boxes meet those of the guides of a group, one bit each.
void findNear(const WispObstacles& obstacles, const LaneVec3& lower, const LaneVec3& upper,
              std::size_t used, std::uint64_t* near) {
  const Vec3 low(lower), high(upper);
  std::fill_n(near, used, std::uint64_t{0});
  for (std::size_t c = 0; c < obstacles.axes.size(); ++c) {
    const WispObstacles::Axis& axis = obstacles.axes[c];
    const Vec3 from(axis.low), to(axis.high);
    std::uint32_t lanes = bits((low.x < to.x) & (low.y < to.y) & (low.z < to.z) &
                               (from.x < high.x) & (from.y < high.y) & (from.z < high.z));
    for (lanes &= (1u << used) - 1; lanes != 0; lanes &= lanes - 1)
      near[__builtin_ctz(lanes)] |= std::uint64_t{1} << c;
  }
}

// Measures the room around one guide, and removes capsules from `near` that are not within kReach.
void measureRoom(const GuideCurves& curves, float clearance, std::size_t guide,
                 WispObstacles& obstacles) {
  const std::size_t samples = curves.samples;
  const float* x = curves.row(guide, GuideCurves::kPoint);
  float* room = obstacles.room.data() + guide * 2 * samples;
  std::uint64_t near = 0;
  for (std::size_t k = 0; k < samples; k += kLanes) {
    if (k + kLanes > samples && samples > kLanes) k = samples - kLanes;
    const Vec3 p(loadFloats(x + k), loadFloats(x + samples + k), loadFloats(x + 2 * samples + k));
    const Mask used = firstLanes(samples - k);
    // Find the distances to the head and to everything else.
    Floats toHead(1.0f), toBody(WispObstacles::kReach);
    if (obstacles.head) {
      const HeadLookup head(obstacles);
      const Vec3 q = head.inHead(p);
      toHead = atLeast(head.sdf.distance(q, used), obstacles.head->field().cell);
      toHead = toHead - Floats(clearance);
    }
    for (std::uint64_t rest = obstacles.near[guide]; rest != 0; rest &= rest - 1) {
      const int c = __builtin_ctzll(rest);
      const WispObstacles::Axis& axis = obstacles.axes[static_cast<std::size_t>(c)];
      const Vec3 out = fromAxis(axis, p);
      const Floats d2 = dot(out, out);
      const float reach = WispObstacles::kReach + axis.keep;
      if (!any(used & (d2 < Floats(reach * reach)))) continue;
      near |= std::uint64_t{1} << c;
      toBody = min(toBody, sqrt(d2) - Floats(axis.keep));
    }
    for (const WispObstacles::Face& face : obstacles.faces) toBody = min(toBody, beyond(face, p));
    for (const WispObstacles::Mesh& mesh : obstacles.meshes) {
      const MeshLookup lookup(mesh);
      const Floats d = lookup.sdf.distance(lookup.inMesh(p), used);
      const Floats scale = mesh.scale;
      toBody = min(toBody, scale * atLeast(d, mesh.sdf->field().cell) - Floats(mesh.keep));
    }
    // Store them squared, as points compare squared distances.
    const auto squared = [](Floats d) HWY_ATTR {
      d = max(d - Floats(kSlack), Floats(0.0f));
      return d * d;
    };
    Lanes rows[2];
    store(squared(toHead), rows[0]);
    store(squared(toBody), rows[1]);
    for (std::size_t r = 0; r < 2; ++r)
      std::copy_n(reinterpret_cast<const float*>(&rows[r]), std::min(kLanes, samples),
                  room + r * samples + k);
  }
  obstacles.near[guide] = near;
}

// Measures the groups [begin, end) of the guides.
void measureGroups(const GuideCurves& curves, float clearance, std::size_t begin, std::size_t end,
                   WispObstacles& obstacles) {
  for (std::size_t group = begin; group < end; ++group) {
    const std::size_t first = group * kLanes,
                      used = std::min(kLanes, obstacles.near.size() - first);
    findNear(obstacles, curves.lower[group], curves.upper[group], used, &obstacles.near[first]);
    for (std::size_t l = 0; l < used; ++l) measureRoom(curves, clearance, first + l, obstacles);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

HWY_EXPORT(measureGroups);

}  // namespace

void findObstacles(const ColliderState& colliders, float clearance, const GuideCurves& curves,
                   WispObstacles& obstacles) {
  require(colliders.capsules.size() <= 64, "interpolateWisps: ", colliders.capsules.size(),
          " capsules; at most 64");
  validate(colliders.scenery);
  obstacles.head = colliders.head;
  obstacles.worldFromHead = glm::mat3_cast(colliders.worldFromHead.rotation);
  obstacles.translation = colliders.worldFromHead.translation;
  obstacles.axes.clear();
  for (const Capsule& c : colliders.capsules) {
    const glm::vec3 axis = c.b - c.a;
    const float length2 = glm::dot(axis, axis), keep = c.radius + clearance;
    const glm::vec3 reach(keep + WispObstacles::kReach);
    obstacles.axes.push_back({c.a, axis, length2 > 0 ? 1.0f / length2 : 0.0f, keep,
                              glm::min(c.a, c.b) - reach, glm::max(c.a, c.b) + reach});
  }
  obstacles.faces.clear();
  for (const Plane& plane : colliders.scenery.planes)
    obstacles.faces.push_back({plane.normal, glm::dot(plane.normal, plane.point) + clearance});
  obstacles.meshes.clear();
  for (const MeshCollider& mesh : colliders.scenery.meshes)
    obstacles.meshes.push_back({mesh.sdf, glm::mat3_cast(mesh.worldFromMesh.rotation),
                                mesh.worldFromMesh.translation, mesh.scale, clearance});
  obstacles.near.resize(curves.guideCount());
  obstacles.room.resize(obstacles.near.size() * 2 * curves.samples + kLanes);
  if (obstacles.none()) return;
  const auto measure = HWY_DYNAMIC_DISPATCH(measureGroups);
  parallelFor(curves.lower.size(), 2, [&](std::size_t begin, std::size_t end) {
    measure(curves, clearance, begin, end, obstacles);
  });
}

}  // namespace hair

#endif  // HWY_ONCE

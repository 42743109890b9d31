// Contact of sixteen strands with planes and meshes; included by the solver's kernel
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_SCENERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_SCENERY_INL_H
#undef HAIR_GUIDES_SCENERY_INL_H
#else
#define HAIR_GUIDES_SCENERY_INL_H
#endif

#include <algorithm>
#include <span>

#include <libhair/core/simd-inl.h>
#include <libhair/geometry/mesh_sdf-inl.h>
#include <libhair/guides/nearby-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Planes and meshes near the strands, with the distances that points must keep from them.
struct NearPlane {
  const PlanePlace* place;
  RequiredDistance reach;
};
struct NearMesh {
  const MeshPlace* place;
  RequiredDistance reach;
};
struct NearScenery {
  std::span<const NearPlane> planes;
  std::span<const NearMesh> meshes;

  bool empty() const { return planes.empty() && meshes.empty(); }
};

HWY_INLINE Floats distanceTo(const PlanePlace& plane, const Vec3& p) {
  return dot(Vec3(plane.normal), p - Vec3(plane.point));
}
HWY_INLINE Floats distanceTo(const MeshPlace& mesh, const Vec3& p) {
  const Vec3 local = rotate(mesh.meshFromWorld, p - Vec3(mesh.at));
  return Floats(mesh.scale) * SdfLookup(*mesh.sdf).distance(local, !none());
}

/// Broad phase: collects the planes and meshes near the box around `x` [points] of sixteen strands.
/// `anchors`: rest positions, carried by the head, of points 1 to kAnchoredPoints.
HWY_NOINLINE inline NearScenery findScenery(const SubstepColliders& colliders, std::uint32_t points,
                                            const Vec3* x, const Vec3* anchors, float skin,
                                            NearPlane* planes, NearMesh* meshes) {
  Box all{x[0], x[0]};
  for (std::uint32_t i = 1; i < points; ++i) all.add(x[i], x[i]);
  const glm::vec3 least = all.least(), most = all.most();
  const float reach = skin + kSight;
  const auto look = [&](const auto& place, auto& near) HWY_ATTR {
    Floats held[kAnchoredPoints];
    for (std::uint32_t i = 0; i < kAnchoredPoints; ++i) held[i] = distanceTo(place, anchors[i]);
    near.place = &place;
    near.reach.set(held, skin, skin);
  };
  std::size_t planeCount = 0, meshCount = 0;
  // Test the corner of the box that is deepest behind each plane, and the boxes of meshes.
  for (const PlanePlace& plane : colliders.planes) {
    const glm::vec3 lowest = glm::mix(least, most, glm::lessThan(plane.normal, glm::vec3(0)));
    if (glm::dot(plane.normal, lowest - plane.point) < reach) look(plane, planes[planeCount++]);
  }
  for (const MeshPlace& mesh : colliders.meshes)
    if (glm::all(glm::lessThan(mesh.box.lower - reach, most)) &&
        glm::all(glm::lessThan(least, mesh.box.upper + reach)))
      look(mesh, meshes[meshCount++]);
  return {{planes, planeCount}, {meshes, meshCount}};
}

/// Replaces `best` by the plane in the lanes where that is nearer; returns true if there is one.
HWY_INLINE bool nearerPlane(const Vec3& p, const PlanePlace& plane, Floats keep,
                            ContactPlane& best) {
  const Vec3 normal(plane.normal), fromPoint = p - Vec3(plane.point);
  const Floats d = dot(normal, fromPoint) - keep;
  const Mask nearer = d < best.distance;
  if (!any(nearer)) return false;
  const Vec3 move = rotate(plane.carry, fromPoint) + Vec3(plane.drift);
  best.normal = select(nearer, normal, best.normal);
  best.offset = select(nearer, dot(normal, p) - d, best.offset);
  best.surfaceMove = select(nearer, move, best.surfaceMove);
  best.distance = select(nearer, d, best.distance);
  return true;
}

/// The same for a mesh, up to kSight away, in the lanes whose lower bound `known` of the distance,
/// metres, does not exceed that; updates `known`. As nearerHead.
HWY_INLINE bool nearerMesh(const Vec3& p, const MeshPlace& mesh, Floats keep, Floats& known,
                           ContactPlane& best) {
  const Floats enough = kSight;
  const Mask look = !(known > enough);
  if (!any(look)) {
    best.distance = min(known, best.distance);
    return false;
  }
  const SdfLookup sdf(*mesh.sdf);
  const Vec3 local = rotate(mesh.meshFromWorld, p - Vec3(mesh.at));
  const Floats scale = mesh.scale, bound = scale * sdf.lowerBound(local, look) - keep;
  const Mask near = look & !(bound > enough);
  Floats d = bound;
  if (any(near)) d = select(near, scale * sdf.distance(local, near) - keep, bound);
  known = select(look, d, known);
  const Mask nearer = known < best.distance, touches = look & nearer & !(known > enough);
  best.distance = select(nearer, known, best.distance);
  best.offset = select(look & nearer, Floats(-kFar), best.offset);
  if (!any(touches)) return false;
  const Vec3 normal = rotate(mesh.turn, sdf.direction(local, touches));
  const Vec3 move = p - (rotate(mesh.worldFromMeshBefore, local) + Vec3(mesh.atBefore));
  best.normal = select(touches, normal, best.normal);
  best.offset = select(touches, dot(normal, p) - known, best.offset);
  best.surfaceMove = select(touches, move, best.surfaceMove);
  return true;
}

/// A lower bound of the distance to all meshes, lowered from point to point of a strand by the
/// distance between them.
struct MeshClearance {
  Floats left = 0.0f;
  /// A mesh covers an anchored point: required distances grow too, at most as fast as the path.
  bool covered;

  HWY_INLINE explicit MeshClearance(const NearScenery& scenery)
      : covered(std::ranges::any_of(scenery.meshes,
                                    [](const NearMesh& near) { return near.reach.covered(); })) {}
  HWY_INLINE void step(Floats way) { left = left - (covered ? way + way : way); }
};

/// The same for all scenery, after capsules and head, for point `index` of its strand, `way` metres
/// after the last anchored one. `slack`: metres by which required distances are reduced. `near`:
/// `plane` holds a plane, not only a distance; returns whether it does afterwards. `clearance`:
/// lower bound of the distance to all meshes; updated.
HWY_NOINLINE inline bool nearerScenery(const Vec3& p, std::uint32_t index, const Floats& way,
                                       const NearScenery& scenery, float slack, bool near,
                                       Floats& clearance, ContactPlane& plane) {
  if (!near) plane = {Vec3(glm::vec3(0)), -kFar, Vec3(glm::vec3(0)), plane.distance};
  for (const NearPlane& at : scenery.planes)
    near |= nearerPlane(p, *at.place, at.reach.of(index, way) - Floats(slack), plane);
  if (scenery.meshes.empty()) return near;
  if (!any(clearance < Floats(kSight))) {
    plane.distance = min(plane.distance, clearance);
    return near;
  }
  Floats nearest = kFar;
  for (const NearMesh& at : scenery.meshes) {
    Floats known = clearance;
    near |= nearerMesh(p, *at.place, at.reach.of(index, way) - Floats(slack), known, plane);
    nearest = min(nearest, known);
  }
  clearance = nearest;
  return near;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

// Distances of sixteen points to the obstacles of drawn strands. Compiled once per instruction set,
// as core/simd-inl.h is.
#if defined(HAIR_WISPS_OBSTACLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_WISPS_OBSTACLES_INL_H
#undef HAIR_WISPS_OBSTACLES_INL_H
#else
#define HAIR_WISPS_OBSTACLES_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/geometry/mesh_sdf-inl.h>
#include <libhair/wisps/obstacles.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// The head's distance field for points in world space.
struct HeadLookup {
  SdfLookup sdf;
  glm::mat3 turn;
  glm::vec3 translation;

  explicit HeadLookup(const WispObstacles& obstacles)
      : sdf(*obstacles.head), turn(obstacles.worldFromHead), translation(obstacles.translation) {}

  HWY_INLINE Vec3 inHead(Vec3 world) const {
    const Vec3 p = world - Vec3(translation);
    return {dot(p, Vec3(turn[0])), dot(p, Vec3(turn[1])), dot(p, Vec3(turn[2]))};
  }
};

/// A mesh's distance field for points in world space.
struct MeshLookup {
  SdfLookup sdf;
  const WispObstacles::Mesh& mesh;

  explicit MeshLookup(const WispObstacles::Mesh& m) : sdf(*m.sdf), mesh(m) {}

  HWY_INLINE Vec3 inMesh(Vec3 world) const {
    const Vec3 p = rotate(glm::transpose(mesh.worldFromMesh), world - Vec3(mesh.translation));
    return Floats(1.0f / mesh.scale) * p;
  }
  /// Signed distance beyond the required one, metres.
  HWY_INLINE Floats beyond(Vec3 inMesh, Mask wanted) const {
    return Floats(mesh.scale) * sdf.distance(inMesh, wanted) - Floats(mesh.keep);
  }
};

/// Signed distance beyond the required one, metres.
HWY_INLINE Floats beyond(const WispObstacles::Face& face, Vec3 p) {
  return dot(Vec3(face.normal), p) - Floats(face.offset);
}

/// Lower bound of the true distance, from that of a field with these cells: a quarter of a cell
/// less near the surface, and a cell less far from it (MeshSdf).
HWY_INLINE Floats atLeast(Floats distance, float cell) {
  return select(distance < Floats(2.0f * cell), distance - Floats(0.25f * cell),
                max(distance - Floats(cell), Floats(1.75f * cell)));
}

/// Vectors from the axis of a capsule to points.
HWY_INLINE Vec3 fromAxis(const WispObstacles::Axis& c, Vec3 p) {
  const Vec3 fromA = p - Vec3(c.a), axis(c.axis);
  const Floats t = min(max(dot(fromA, axis) * Floats(c.perLength2), Floats(0.0f)), Floats(1.0f));
  return fromA - t * axis;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

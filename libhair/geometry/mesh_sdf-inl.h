// Look-ups in a MeshSdf for sixteen points at once; included by kernels (core/simd-inl.h).
#if defined(HAIR_MODEL_MESH_SDF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_MODEL_MESH_SDF_INL_H
#undef HAIR_MODEL_MESH_SDF_INL_H
#else
#define HAIR_MODEL_MESH_SDF_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/geometry/mesh_sdf.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// MeshSdf's member functions of the same names, bit for bit in every lane of `wanted`; other lanes
/// are undefined, and read only the first node.
class SdfLookup {
 public:
  explicit SdfLookup(const MeshSdf& sdf)
      : field_(sdf.field()), nodes_(sdf.nodes()), dy_(nodes_.x), dz_(nodes_.x * nodes_.y) {}

  HWY_INLINE Floats lowerBound(const Vec3& p, Mask wanted) const {
    const Vec3 inBox = clampToBox(p);
    const Mask inside = wanted & same(p, inBox);
    const Vec3 q = gridOf(inBox);
    const Ints at = truncate(q.x + Floats(0.5f)) + Ints(dy_) * truncate(q.y + Floats(0.5f)) +
                    Ints(dz_) * truncate(q.z + Floats(0.5f));
    const Floats node = gather(field_.distances, select(inside, at, Ints(0)));
    return select(inside, node - Floats(field_.cell), Floats(field_.margin));
  }

  HWY_INLINE Floats distance(const Vec3& p, Mask wanted) const {
    const Vec3 inBox = clampToBox(p);
    const Mask inside = same(p, inBox);
    const Floats outside = length(p - inBox) + Floats(field_.margin);
    return select(inside, Around(*this, inBox, wanted & inside).mix(field_.distances, 1), outside);
  }

  /// Unit outward direction: xyz of distanceAndGradient.
  HWY_INLINE Vec3 direction(const Vec3& p, Mask wanted) const {
    const Vec3 inBox = clampToBox(p);
    const Mask inside = same(p, inBox);
    const Around around(*this, inBox, wanted & inside);
    const float* gradients = &field_.gradients->x;
    const Vec3 gradient(around.mix(gradients, 3), around.mix(gradients + 1, 3),
                        around.mix(gradients + 2, 3));
    const Vec3 way = select(inside, gradient, p - inBox);
    const Floats l = length(way);
    return select(l > Floats(1e-6f), (Floats(1.0f) / l) * way, Vec3(glm::vec3(0, 1, 0)));
  }

 private:
  // The eight nodes around points of the box, and their trilinear weights.
  struct Around {
    Ints first, dy, dz;
    Vec3 t, s;

    HWY_INLINE Around(const SdfLookup& sdf, const Vec3& inBox, Mask wanted)
        : dy(sdf.dy_), dz(sdf.dz_) {
      const Vec3 q = sdf.gridOf(inBox);
      const Ints x = min(truncate(q.x), Ints(sdf.nodes_.x - 2)),
                 y = min(truncate(q.y), Ints(sdf.nodes_.y - 2)),
                 z = min(truncate(q.z), Ints(sdf.nodes_.z - 2));
      t = q - Vec3(toFloats(x), toFloats(y), toFloats(z));
      s = Vec3(glm::vec3(1)) - t;
      first = select(wanted, x + dy * y + dz * z, Ints(0));
    }
    HWY_INLINE Floats row(const float* values, int stride, Ints at) const {
      if (stride != 1) return gather(values, at) * s.x + gather(values + stride, at) * t.x;
      const Pairs v = gatherPairs(values, at);
      return v.first * s.x + v.second * t.x;
    }
    // Interpolates every stride-th value.
    HWY_INLINE Floats mix(const float* values, int stride) const {
      const Ints at = Ints(stride) * first, y = Ints(stride) * dy, z = Ints(stride) * dz;
      const Floats near = row(values, stride, at) * s.y + row(values, stride, at + y) * t.y;
      const Floats far = row(values, stride, at + z) * s.y + row(values, stride, at + z + y) * t.y;
      return near * s.z + far * t.z;
    }
  };

  HWY_INLINE Vec3 clampToBox(const Vec3& p) const {
    const Vec3 lower(field_.box.lower), upper(field_.box.upper);
    return {min(max(p.x, lower.x), upper.x), min(max(p.y, lower.y), upper.y),
            min(max(p.z, lower.z), upper.z)};
  }
  HWY_INLINE Vec3 gridOf(const Vec3& inBox) const {
    return Floats(field_.perCell) * (inBox - Vec3(field_.box.lower));
  }
  static HWY_INLINE Mask same(const Vec3& a, const Vec3& b) {
    return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
  }

  MeshSdf::Field field_;
  glm::ivec3 nodes_;
  std::int32_t dy_, dz_;
};

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

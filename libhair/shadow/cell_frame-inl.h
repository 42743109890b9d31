// CellFrame::cellCoordinates of sixteen points at once, with the same bits; see core/simd-inl.h.
#if defined(HAIR_SHADOW_CELL_FRAME_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_SHADOW_CELL_FRAME_INL_H
#undef HAIR_SHADOW_CELL_FRAME_INL_H
#else
#define HAIR_SHADOW_CELL_FRAME_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/shadow/light_space.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// CellFrame::bend.
HWY_INLINE Vec3 bend(Vec3 v, float k) {
  const Floats ahead = 1.0f + k * v.x;
  const Floats across = (k * k) * (v.y * v.y + v.z * v.z);
  const Floats rho = sqrt(ahead * ahead + across);
  const Floats sum =
      select(ahead > Floats(0.0f), rho + ahead, across / (rho - ahead + Floats(1e-30f)));
  const Mask behind = sum < Floats(1e-12f);
  const Floats g = 2.0f / sum;
  const Floats x = (2.0f * v.x + k * (v.x * v.x + v.y * v.y + v.z * v.z)) / (1.0f + rho);
  return {select(behind, v.x, x), select(behind, Floats(1e9f), g * v.y),
          select(behind, Floats(1e9f), g * v.z)};
}

HWY_INLINE Floats clampCoordinate(Floats u) {
  return min(max(u, Floats(-1e9f)), Floats(1e9f));
}

HWY_INLINE Vec3 cellCoordinates(const CellFrame& frame, Vec3 p) {
  const glm::mat3& m = frame.cellFromWorld;
  const Vec3 d = p - Vec3(frame.anchor);
  Vec3 u = Vec3(frame.fraction) + rotate(m, d);
  if (frame.curvature > 0) u = bend(u, frame.curvature);
  return {clampCoordinate(u.x), clampCoordinate(u.y), clampCoordinate(u.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

// The weights of FootprintKernel, sixteen at once; see core/simd-inl.h.
#if defined(HAIR_SHADOW_FOOTPRINT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_SHADOW_FOOTPRINT_INL_H
#undef HAIR_SHADOW_FOOTPRINT_INL_H
#else
#define HAIR_SHADOW_FOOTPRINT_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/shadow/footprint.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Integral of the tent function from -1 to t.
HWY_INLINE Floats tentBelow(Floats t) {
  t = min(max(t, Floats(-1.0f)), Floats(1.0f));
  const Floats rise = t + 1.0f, fall = 1.0f - t;
  return select(t < Floats(0.0f), 0.5f * rise * rise, 1.0f - 0.5f * fall * fall);
}

/// Weights of cells whose centres are `t` cells from the point: linear interpolation averaged over
/// the kernel's box.
HWY_INLINE Floats footprintWeights(const FootprintKernel& kernel, Floats t) {
  const float h = kernel.halfWidth;
  return (0.5f / h) * (tentBelow(t + h) - tentBelow(t - h));
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

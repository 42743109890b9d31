// Wind at sixteen points at once; included by kernels (core/simd-inl.h).
#if defined(HAIR_MOTION_WIND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_MOTION_WIND_INL_H
#undef HAIR_MOTION_WIND_INL_H
#else
#define HAIR_MOTION_WIND_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/motion/wind.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// sin(2 pi t); absolute error below 3e-7 beyond the rounding of t itself, |t| below 2^20.
HWY_INLINE Floats sineOfTurns(Floats t) {
  // t is f beyond n half turns, |f| <= 1/4: adding 1.5 · 2^23 rounds to a whole number, the lowest
  // bit of which says whether n is odd.
  const Floats biased = t + t + 12582912.0f;
  const Floats f = t - 0.5f * (biased - 12582912.0f);
  const Floats x = 6.28318531f * f, xx = x * x;
  // Taylor; the first term left out is below 6e-8.
  Floats p = -2.5052108e-8f;
  p = p * xx + 2.7557319e-6f;
  p = p * xx - 1.9841270e-4f;
  p = p * xx + 8.3333333e-3f;
  p = p * xx - 0.16666667f;
  p = p * (xx * x) + x;
  return select((asInts(biased) & Ints(1)) > Ints(0), -p, p);
}

/// WindField::at.
HWY_INLINE Vec3 blow(const WindField& wind, const Vec3& p) {
  Vec3 v(wind.steady);
  for (const WindField::Wave& wave : wind.waves)
    v = v + sineOfTurns(dot(Vec3(wave.perMetre), p) + Floats(wave.phase)) * Vec3(wave.swing);
  return v;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

// Sixteen strands or points side by side, on whatever vectors the CPU has.
//
// This header is compiled once per instruction set (Google Highway's foreach_target), so it has no
// `#pragma once`. A kernel is a .cpp file that starts with
//
//   #undef HWY_TARGET_INCLUDE
//   #define HWY_TARGET_INCLUDE "libhair/<folder>/<this file>.cpp"
//   #include <hwy/foreach_target.h>
//   #include <libhair/core/simd-inl.h>
//
// has its passes between HWY_BEFORE_NAMESPACE() and HWY_AFTER_NAMESPACE(), in hair::HWY_NAMESPACE,
// and picks the best of them in its `#if HWY_ONCE` part, with HWY_EXPORT and HWY_DYNAMIC_DISPATCH.
// Lambdas there carry HWY_ATTR.
//
// Every operation rounds as the scalar one does, and nothing is contracted: a kernel gives the same
// bits on every instruction set, and for any distribution of its items over lanes.
#if defined(HAIR_CORE_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_CORE_SIMD_INL_H
#undef HAIR_CORE_SIMD_INL_H
#else
#define HAIR_CORE_SIMD_INL_H
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#include <libhair/core/lanes.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

#if HWY_MAX_BYTES < 32
#include <libhair/core/simd_plain-inl.h>
#else
namespace hn = hwy::HWY_NAMESPACE;
#include <libhair/core/simd_highway-inl.h>
#endif

HWY_INLINE Ints floorToInt(Floats v) {
  const Ints whole = truncate(v);
  return whole - select(v < toFloats(whole), Ints(1), Ints(0));
}
/// Of numbers of 32 bits without signs: rounded once, as the upper half and the lower are exact.
HWY_INLINE Floats toFloatsUnsigned(Ints v) {
  const Floats upper = toFloats(shiftRight<16>(v) & Ints(0xffff));
  return upper * 65536.0f + toFloats(v & Ints(0xffff));
}
HWY_INLINE Ints gather(const std::uint32_t* from, Ints index) {
  return gather(reinterpret_cast<const std::int32_t*>(from), index);
}

/// Sixteen times sixteen values: lane l of row r becomes lane r of row l.
HWY_INLINE void transpose(Floats (&rows)[kLanes]) {
  // Each round takes the lowest bit of the lane's number and makes it the highest of the row's.
  for (std::size_t bit = 1; bit < kLanes; bit *= 2) {
    Floats r[kLanes];
    for (std::size_t i = 0; i < kLanes / 2; ++i) {
      r[i] = evenLanes(rows[2 * i], rows[2 * i + 1]);
      r[i + kLanes / 2] = oddLanes(rows[2 * i], rows[2 * i + 1]);
    }
    for (std::size_t i = 0; i < kLanes; ++i) rows[i] = r[i];
  }
}

/// exp(-x) for x >= 0: the bits of the scalar function (approximate.h).
HWY_INLINE Floats expMinusApproximate(Floats x) {
  x = min(x, Floats(87.0f));
  // The lowest bits of this are those of the whole number n.
  const Floats biased = x * 1.44269504f + 12582912.0f;
  const Floats n = biased - 12582912.0f;
  const Floats r = (x - n * 0.693359375f) + n * 2.12194440e-4f;
  Floats e = 1.9841270e-4f;
  e = e * -r + 1.3888889e-3f;
  e = e * -r + 8.3333333e-3f;
  e = e * -r + 4.1666667e-2f;
  e = e * -r + 1.6666667e-1f;
  e = e * -r + 0.5f;
  e = e * (r * r) - r + 1.0f;
  const Ints exponent = shiftLeft<23>(Ints(127) - asInts(biased));
  return min(e * asFloats(exponent), Floats(1.0f));
}

/// 2^x for x in [-126, 127]; relative error below 1e-7 beyond the rounding of x itself; 1 at 0.
/// x outside is clamped.
HWY_INLINE Floats exp2Approximate(Floats x) {
  x = min(max(x, Floats(-126.0f)), Floats(127.0f));
  // x = n + f with f in [-1/2, 1/2]: adding 1.5 · 2^23 rounds to an integer.
  const Floats n = (x + 12582912.0f) - 12582912.0f;
  const Floats f = x - n;
  // Taylor polynomial of 2^f; the first term left out is below 2e-9.
  Floats p = 1.5252734e-5f;
  p = p * f + 1.5403530e-4f;
  p = p * f + 1.3333558e-3f;
  p = p * f + 9.6181291e-3f;
  p = p * f + 5.5504109e-2f;
  p = p * f + 2.4022651e-1f;
  p = p * f + 6.9314718e-1f;
  p = p * f + 1.0f;
  return p * asFloats(shiftLeft<23>(truncate(n) + Ints(127)));
}
/// log2 x for normal x > 0; absolute error below 1e-6 (relative to the larger of 1 and |log2 x|).
HWY_INLINE Floats log2Approximate(Floats x) {
  const Ints bits = asInts(x);
  // x = 2^n m with m in [sqrt(1/2), sqrt 2).
  const Ints n = shiftRight<23>(bits - Ints(0x3f3504f3));
  const Floats m = asFloats(bits - shiftLeft<23>(n));
  // log m = 2 artanh(z), z = (m - 1) / (m + 1), |z| <= 0.172.
  const Floats z = (m - 1.0f) / (m + 1.0f);
  const Floats zz = z * z;
  const Floats series =
      Floats(1.0f) + zz * (0.33333333f + zz * (0.2f + zz * (0.14285714f + zz * 0.1111f)));
  return toFloats(n) + Floats(2.88539008f) * z * series;
}
/// x^y for x in [0, 1], y >= 0; 0 where x is 0.
HWY_INLINE Floats powApproximate(Floats x, Floats y) {
  const Floats p = exp2Approximate(y * log2Approximate(max(x, Floats(1e-30f))));
  return select(x <= 0.0f, Floats(0.0f), p);
}

/// Sixteen vectors side by side.
struct Vec3 {
  Floats x, y, z;
  Vec3() = default;
  HWY_INLINE Vec3(Floats x_, Floats y_, Floats z_) : x(x_), y(y_), z(z_) {}
  HWY_INLINE Vec3(const LaneVec3& v) : x(v.x), y(v.y), z(v.z) {}
  /// The same in every lane.
  HWY_INLINE explicit Vec3(glm::vec3 v) : x(v.x), y(v.y), z(v.z) {}
};

HWY_INLINE void store(Vec3 v, LaneVec3& to) {
  store(v.x, to.x), store(v.y, to.y), store(v.z, to.z);
}
/// Sixteen xyz one after another.
HWY_INLINE Vec3 loadPoints(const glm::vec3* from) {
  Vec3 r;
  loadPoints(&from->x, r.x, r.y, r.z);
  return r;
}
/// The first n >= 1 of them; lanes beyond repeat the last.
HWY_INLINE Vec3 loadPoints(const glm::vec3* from, std::size_t n) {
  if (HWY_LIKELY(n >= kLanes)) return loadPoints(from);
  glm::vec3 all[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) all[l] = from[l < n ? l : n - 1];
  return loadPoints(all);
}
HWY_INLINE void storePoints(Vec3 v, glm::vec3* to) {
  storePoints(v.x, v.y, v.z, &to->x);
}

HWY_INLINE Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vec3 operator*(Floats s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
HWY_INLINE Floats dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Floats length(Vec3 a) {
  return sqrt(dot(a, a));
}
HWY_INLINE Vec3 select(Mask m, Vec3 yes, Vec3 no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
HWY_INLINE Vec3 rotate(const glm::mat3& m, Vec3 v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

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
// bits on every instruction set, and for whatever way its items are spread over lanes.
#if defined(HAIR_CORE_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_CORE_SIMD_INL_H
#undef HAIR_CORE_SIMD_INL_H
#else
#define HAIR_CORE_SIMD_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <libhair/core/lanes.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, kLanes>;
using IntTag = hn::RebindToSigned<FloatTag>;
/// Vectors of the CPU that make up sixteen lanes: one with AVX-512, four with SSE or NEON.
inline constexpr std::size_t kPerPart = hn::MaxLanes(FloatTag());
inline constexpr std::size_t kParts = kLanes / kPerPart;

#define HAIR_EACH_PART for (std::size_t p = 0; p < kParts; ++p)

/// One truth a lane.
struct Mask {
  hn::Mask<FloatTag> part[kParts];
};

struct Ints {
  hn::Vec<IntTag> part[kParts];
  Ints() = default;
  HWY_INLINE Ints(std::int32_t v) { HAIR_EACH_PART part[p] = hn::Set(IntTag(), v); }
};

struct Floats {
  hn::Vec<FloatTag> part[kParts];
  Floats() = default;
  HWY_INLINE Floats(float v) { HAIR_EACH_PART part[p] = hn::Set(FloatTag(), v); }
  /// From storage, which has the alignment that a compiler without these registers gives it.
  HWY_INLINE Floats(const Lanes& v) {
    const float* from = reinterpret_cast<const float*>(&v);
    HAIR_EACH_PART part[p] = hn::LoadU(FloatTag(), from + p * kPerPart);
  }
};

/// Memory of sixteen values, at any address.
HWY_INLINE Floats loadFloats(const float* from) {
  Floats r;
  HAIR_EACH_PART r.part[p] = hn::LoadU(FloatTag(), from + p * kPerPart);
  return r;
}
HWY_INLINE Ints loadInts(const std::int32_t* from) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::LoadU(IntTag(), from + p * kPerPart);
  return r;
}
HWY_INLINE void store(Floats v, float* to) {
  HAIR_EACH_PART hn::StoreU(v.part[p], FloatTag(), to + p * kPerPart);
}
HWY_INLINE void store(Ints v, std::int32_t* to) {
  HAIR_EACH_PART hn::StoreU(v.part[p], IntTag(), to + p * kPerPart);
}
HWY_INLINE void store(Floats v, Lanes& to) {
  HAIR_EACH_PART hn::StoreU(v.part[p], FloatTag(), reinterpret_cast<float*>(&to) + p * kPerPart);
}

#define HAIR_BINARY(Type, name, op)                          \
  HWY_INLINE Type name(Type a, Type b) {                     \
    Type r;                                                  \
    HAIR_EACH_PART r.part[p] = hn::op(a.part[p], b.part[p]); \
    return r;                                                \
  }                                                          \
  static_assert(true)
#define HAIR_UNARY(Type, name, op)                \
  HWY_INLINE Type name(Type a) {                  \
    Type r;                                       \
    HAIR_EACH_PART r.part[p] = hn::op(a.part[p]); \
    return r;                                     \
  }                                               \
  static_assert(true)
HAIR_BINARY(Floats, operator+, Add);
HAIR_BINARY(Floats, operator-, Sub);
HAIR_BINARY(Floats, operator*, Mul);
HAIR_BINARY(Floats, operator/, Div);
HAIR_UNARY(Floats, operator-, Neg);
HAIR_UNARY(Floats, sqrt, Sqrt);
HAIR_UNARY(Floats, abs, Abs);
HAIR_BINARY(Ints, operator+, Add);
HAIR_BINARY(Ints, operator-, Sub);
HAIR_BINARY(Ints, operator*, Mul);
HAIR_BINARY(Ints, operator&, And);
HAIR_BINARY(Ints, operator|, Or);
HAIR_BINARY(Ints, min, Min);
HAIR_BINARY(Ints, max, Max);
HAIR_BINARY(Mask, operator&, And);
HAIR_BINARY(Mask, operator|, Or);
HAIR_UNARY(Mask, operator!, Not);
#undef HAIR_UNARY

#define HAIR_COMPARE(name, op)                               \
  HWY_INLINE Mask name(Floats a, Floats b) {                 \
    Mask r;                                                  \
    HAIR_EACH_PART r.part[p] = hn::op(a.part[p], b.part[p]); \
    return r;                                                \
  }                                                          \
  static_assert(true)
#define HAIR_COMPARE_INTS(name, op)                                                      \
  HWY_INLINE Mask name(Ints a, Ints b) {                                                 \
    Mask r;                                                                              \
    HAIR_EACH_PART r.part[p] = hn::RebindMask(FloatTag(), hn::op(a.part[p], b.part[p])); \
    return r;                                                                            \
  }                                                                                      \
  static_assert(true)
HAIR_COMPARE(operator<, Lt);
HAIR_COMPARE(operator<=, Le);
HAIR_COMPARE(operator>, Gt);
HAIR_COMPARE(operator>=, Ge);
HAIR_COMPARE(operator==, Eq);
HAIR_COMPARE_INTS(operator<, Lt);
HAIR_COMPARE_INTS(operator>, Gt);
HAIR_COMPARE_INTS(operator==, Eq);
#undef HAIR_COMPARE
#undef HAIR_COMPARE_INTS

HWY_INLINE Floats select(Mask m, Floats yes, Floats no) {
  Floats r;
  HAIR_EACH_PART r.part[p] = hn::IfThenElse(m.part[p], yes.part[p], no.part[p]);
  return r;
}
HWY_INLINE Ints select(Mask m, Ints yes, Ints no) {
  Ints r;
  HAIR_EACH_PART r.part[p] =
      hn::IfThenElse(hn::RebindMask(IntTag(), m.part[p]), yes.part[p], no.part[p]);
  return r;
}
/// As std::min and std::max of scalars: b where they cannot be compared, and no signed zeros are
/// told apart.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
// Just what these instructions do.
HAIR_BINARY(Floats, min, Min);
HAIR_BINARY(Floats, max, Max);
#else
HWY_INLINE Floats min(Floats a, Floats b) {
  return select(a < b, a, b);
}
HWY_INLINE Floats max(Floats a, Floats b) {
  return select(a > b, a, b);
}
#endif
/// The lesser of numbers without signs.
HWY_INLINE Ints minUnsigned(Ints a, Ints b) {
  const hn::RebindToUnsigned<IntTag> u;
  Ints r;
  HAIR_EACH_PART r.part[p] =
      hn::BitCast(IntTag(), hn::Min(hn::BitCast(u, a.part[p]), hn::BitCast(u, b.part[p])));
  return r;
}
/// The least and the greatest of the lanes.
HWY_INLINE float lowest(Floats a) {
  auto r = a.part[0];
  HAIR_EACH_PART r = hn::Min(r, a.part[p]);
  return hn::GetLane(hn::MinOfLanes(FloatTag(), r));
}
HWY_INLINE float highest(Floats a) {
  auto r = a.part[0];
  HAIR_EACH_PART r = hn::Max(r, a.part[p]);
  return hn::GetLane(hn::MaxOfLanes(FloatTag(), r));
}
#undef HAIR_BINARY

HWY_INLINE bool any(Mask m) {
  bool r = false;
  HAIR_EACH_PART r |= !hn::AllFalse(FloatTag(), m.part[p]);
  return r;
}
HWY_INLINE bool all(Mask m) {
  bool r = true;
  HAIR_EACH_PART r &= hn::AllTrue(FloatTag(), m.part[p]);
  return r;
}
/// Bit l is lane l.
HWY_INLINE std::uint32_t bits(Mask m) {
  std::uint32_t r = 0;
  HAIR_EACH_PART {
    std::uint8_t b[8] = {};
    hn::StoreMaskBits(FloatTag(), m.part[p], b);
    r |= (std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8) << (p * kPerPart);
  }
  return r;
}
/// Lanes 0 to n - 1.
HWY_INLINE Mask firstLanes(std::size_t n) {
  Mask r;
  HAIR_EACH_PART r.part[p] = hn::FirstN(FloatTag(), n > p * kPerPart ? n - p * kPerPart : 0);
  return r;
}
HWY_INLINE Mask none() {
  return firstLanes(0);
}
/// Lane l where bit l is set.
HWY_INLINE Mask maskOf(std::uint32_t bits) {
  Mask r;
  for (std::size_t p = 0; p < kParts; ++p) {
    const std::uint32_t part = bits >> (p * kPerPart);
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(part),
                                   static_cast<std::uint8_t>(part >> 8)};
    r.part[p] = hn::LoadMaskBits(FloatTag(), bytes);
  }
  return r;
}
/// 0, 1, 2 ... 15.
HWY_INLINE Ints laneNumbers() {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::Iota(IntTag(), static_cast<std::int32_t>(p * kPerPart));
  return r;
}

HWY_INLINE Floats toFloats(Ints v) {
  Floats r;
  HAIR_EACH_PART r.part[p] = hn::ConvertTo(FloatTag(), v.part[p]);
  return r;
}
/// Towards zero; |v| below 2^31.
HWY_INLINE Ints truncate(Floats v) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::ConvertTo(IntTag(), v.part[p]);
  return r;
}
HWY_INLINE Ints floorToInt(Floats v) {
  const Ints whole = truncate(v);
  return whole - select(v < toFloats(whole), Ints(1), Ints(0));
}
template <int kBits>
HWY_INLINE Ints shiftLeft(Ints v) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::ShiftLeft<kBits>(v.part[p]);
  return r;
}
/// Arithmetic: negative numbers stay negative.
template <int kBits>
HWY_INLINE Ints shiftRight(Ints v) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::ShiftRight<kBits>(v.part[p]);
  return r;
}
HWY_INLINE Floats asFloats(Ints v) {
  Floats r;
  HAIR_EACH_PART r.part[p] = hn::BitCast(FloatTag(), v.part[p]);
  return r;
}
HWY_INLINE Ints asInts(Floats v) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::BitCast(IntTag(), v.part[p]);
  return r;
}

/// from[index], each lane its own.
HWY_INLINE Floats gather(const float* from, Ints index) {
  Floats r;
  HAIR_EACH_PART r.part[p] = hn::GatherIndex(FloatTag(), from, index.part[p]);
  return r;
}
HWY_INLINE Ints gather(const std::int32_t* from, Ints index) {
  Ints r;
  HAIR_EACH_PART r.part[p] = hn::GatherIndex(IntTag(), from, index.part[p]);
  return r;
}
HWY_INLINE Ints gather(const std::uint32_t* from, Ints index) {
  return gather(reinterpret_cast<const std::int32_t*>(from), index);
}
/// from[index] and from[index + 1].
struct Pairs {
  Floats first, second;
};
HWY_INLINE Pairs gatherPairs(const float* from, Ints index) {
#if HWY_MAX_BYTES >= 32
  // One look-up of 64 bits instead of two of 32.
  const hn::Repartition<std::int64_t, FloatTag> wide;
  const auto base = reinterpret_cast<const std::int64_t*>(from);
  Pairs r;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto low = hn::PromoteTo(wide, hn::LowerHalf(index.part[p]));
    const auto high = hn::PromoteTo(wide, hn::UpperHalf(hn::Half<IntTag>(), index.part[p]));
    const auto a = hn::GatherOffset(wide, base, hn::ShiftLeft<2>(low));
    const auto b = hn::GatherOffset(wide, base, hn::ShiftLeft<2>(high));
    const FloatTag f;
    r.first.part[p] = hn::ConcatEven(f, hn::BitCast(f, b), hn::BitCast(f, a));
    r.second.part[p] = hn::ConcatOdd(f, hn::BitCast(f, b), hn::BitCast(f, a));
  }
  return r;
#else
  return {gather(from, index), gather(from + 1, index)};
#endif
}
/// Writes the lanes of m one after another; returns how many. Up to kLanes values past them may be
/// overwritten.
HWY_INLINE std::size_t compress(Ints v, Mask m, std::int32_t* to) {
  std::size_t n = 0;
  // In a register first: compressing into memory is slow.
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto part = hn::RebindMask(IntTag(), m.part[p]);
    hn::StoreU(hn::Compress(v.part[p], part), IntTag(), to + n);
    n += hn::CountTrue(IntTag(), part);
  }
  return n;
}

/// Part i of a and b one after the other.
HWY_INLINE hn::Vec<FloatTag> partOf(const Floats& a, const Floats& b, std::size_t i) {
  return i < kParts ? a.part[i] : b.part[i - kParts];
}
/// Lanes 0, 2, 4 ... of a, then those of b.
HWY_INLINE Floats evenLanes(Floats a, Floats b) {
  Floats r;
#if HWY_TARGET == HWY_SCALAR
  HAIR_EACH_PART r.part[p] = partOf(a, b, 2 * p);
#else
  HAIR_EACH_PART r.part[p] =
      hn::ConcatEven(FloatTag(), partOf(a, b, 2 * p + 1), partOf(a, b, 2 * p));
#endif
  return r;
}
/// Lanes 1, 3, 5 ... of a, then those of b.
HWY_INLINE Floats oddLanes(Floats a, Floats b) {
  Floats r;
#if HWY_TARGET == HWY_SCALAR
  HAIR_EACH_PART r.part[p] = partOf(a, b, 2 * p + 1);
#else
  HAIR_EACH_PART r.part[p] =
      hn::ConcatOdd(FloatTag(), partOf(a, b, 2 * p + 1), partOf(a, b, 2 * p));
#endif
  return r;
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

/// exp(-x) for x >= 0: the bits of expMinusApproximate.
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

/// The bits of the scalar functions of the same names.
HWY_INLINE Floats exp2Approximate(Floats x) {
  x = min(max(x, Floats(-126.0f)), Floats(127.0f));
  const Floats n = (x + 12582912.0f) - 12582912.0f;
  const Floats f = x - n;
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
HWY_INLINE Floats log2Approximate(Floats x) {
  const Ints bits = asInts(x);
  const Ints n = shiftRight<23>(bits - Ints(0x3f3504f3));
  const Floats m = asFloats(bits - shiftLeft<23>(n));
  const Floats z = (m - 1.0f) / (m + 1.0f);
  const Floats zz = z * z;
  const Floats series =
      Floats(1.0f) + zz * (0.33333333f + zz * (0.2f + zz * (0.14285714f + zz * 0.1111f)));
  return toFloats(n) + Floats(2.88539008f) * z * series;
}
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
  const float* xyz = &from->x;
  HAIR_EACH_PART hn::LoadInterleaved3(FloatTag(), xyz + 3 * p * kPerPart, r.x.part[p], r.y.part[p],
                                      r.z.part[p]);
  return r;
}
HWY_INLINE void storePoints(Vec3 v, glm::vec3* to) {
  float* xyz = &to->x;
  HAIR_EACH_PART hn::StoreInterleaved3(v.x.part[p], v.y.part[p], v.z.part[p], FloatTag(),
                                       xyz + 3 * p * kPerPart);
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

#undef HAIR_EACH_PART

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

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

// clang-format off
#define HAIR_PARTS(statement) \
  for (std::size_t p = 0; p < kParts; ++p) { statement; }
// clang-format on

/// One truth a lane.
struct Mask {
  hn::Mask<FloatTag> part[kParts];
};

struct Ints {
  hn::Vec<IntTag> part[kParts];
  Ints() = default;
  HWY_INLINE Ints(std::int32_t v) { HAIR_PARTS(part[p] = hn::Set(IntTag(), v)) }
};

struct Floats {
  hn::Vec<FloatTag> part[kParts];
  Floats() = default;
  HWY_INLINE Floats(float v) { HAIR_PARTS(part[p] = hn::Set(FloatTag(), v)) }
  /// From storage, which is aligned as the widest registers of the common code want it, no more.
  HWY_INLINE Floats(const Lanes& v) {
    const float* from = reinterpret_cast<const float*>(&v);
    HAIR_PARTS(part[p] = hn::LoadU(FloatTag(), from + p * kPerPart))
  }
};

/// Memory of sixteen values, at any address.
HWY_INLINE Floats loadFloats(const float* from) {
  Floats r;
  HAIR_PARTS(r.part[p] = hn::LoadU(FloatTag(), from + p * kPerPart))
  return r;
}
HWY_INLINE Ints loadInts(const std::int32_t* from) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::LoadU(IntTag(), from + p * kPerPart))
  return r;
}
HWY_INLINE void store(Floats v, float* to) {
  HAIR_PARTS(hn::StoreU(v.part[p], FloatTag(), to + p * kPerPart))
}
HWY_INLINE void store(Ints v, std::int32_t* to) {
  HAIR_PARTS(hn::StoreU(v.part[p], IntTag(), to + p * kPerPart))
}
HWY_INLINE void store(Floats v, Lanes& to) {
  HAIR_PARTS(hn::StoreU(v.part[p], FloatTag(), reinterpret_cast<float*>(&to) + p * kPerPart))
}

#define HAIR_BINARY(Type, name, op)                          \
  HWY_INLINE Type name(Type a, Type b) {                     \
    Type r;                                                  \
    HAIR_PARTS(r.part[p] = hn::op(a.part[p], b.part[p]))     \
    return r;                                                \
  }
#define HAIR_UNARY(Type, name, op)             \
  HWY_INLINE Type name(Type a) {               \
    Type r;                                    \
    HAIR_PARTS(r.part[p] = hn::op(a.part[p]))  \
    return r;                                  \
  }
HAIR_BINARY(Floats, operator+, Add)
HAIR_BINARY(Floats, operator-, Sub)
HAIR_BINARY(Floats, operator*, Mul)
HAIR_BINARY(Floats, operator/, Div)
HAIR_UNARY(Floats, operator-, Neg)
HAIR_UNARY(Floats, sqrt, Sqrt)
HAIR_UNARY(Floats, abs, Abs)
HAIR_BINARY(Ints, operator+, Add)
HAIR_BINARY(Ints, operator-, Sub)
HAIR_BINARY(Ints, operator*, Mul)
HAIR_BINARY(Ints, operator&, And)
HAIR_BINARY(Ints, operator|, Or)
HAIR_BINARY(Ints, min, Min)
HAIR_BINARY(Ints, max, Max)
HAIR_BINARY(Mask, operator&, And)
HAIR_BINARY(Mask, operator|, Or)
HAIR_UNARY(Mask, operator!, Not)
#undef HAIR_UNARY

#define HAIR_COMPARE(name, op)                               \
  HWY_INLINE Mask name(Floats a, Floats b) {                 \
    Mask r;                                                  \
    HAIR_PARTS(r.part[p] = hn::op(a.part[p], b.part[p]))     \
    return r;                                                \
  }
#define HAIR_COMPARE_INTS(name, op)                                                    \
  HWY_INLINE Mask name(Ints a, Ints b) {                                               \
    Mask r;                                                                            \
    HAIR_PARTS(r.part[p] = hn::RebindMask(FloatTag(), hn::op(a.part[p], b.part[p])))   \
    return r;                                                                          \
  }
HAIR_COMPARE(operator<, Lt)
HAIR_COMPARE(operator<=, Le)
HAIR_COMPARE(operator>, Gt)
HAIR_COMPARE(operator>=, Ge)
HAIR_COMPARE(operator==, Eq)
HAIR_COMPARE_INTS(operator<, Lt)
HAIR_COMPARE_INTS(operator>, Gt)
HAIR_COMPARE_INTS(operator==, Eq)
#undef HAIR_COMPARE
#undef HAIR_COMPARE_INTS

HWY_INLINE Floats select(Mask m, Floats yes, Floats no) {
  Floats r;
  HAIR_PARTS(r.part[p] = hn::IfThenElse(m.part[p], yes.part[p], no.part[p]))
  return r;
}
HWY_INLINE Ints select(Mask m, Ints yes, Ints no) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::IfThenElse(hn::RebindMask(IntTag(), m.part[p]), yes.part[p],
                                        no.part[p]))
  return r;
}
/// As std::min and std::max of scalars: b where they cannot be compared, and no signed zeros are
/// told apart.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
// What the instructions of x86 do.
HAIR_BINARY(Floats, min, Min)
HAIR_BINARY(Floats, max, Max)
#else
HWY_INLINE Floats min(Floats a, Floats b) { return select(a < b, a, b); }
HWY_INLINE Floats max(Floats a, Floats b) { return select(a > b, a, b); }
#endif
/// The least and the greatest of the lanes.
HWY_INLINE float lowest(Floats a) {
  auto r = a.part[0];
  HAIR_PARTS(r = hn::Min(r, a.part[p]))
  return hn::GetLane(hn::MinOfLanes(FloatTag(), r));
}
HWY_INLINE float highest(Floats a) {
  auto r = a.part[0];
  HAIR_PARTS(r = hn::Max(r, a.part[p]))
  return hn::GetLane(hn::MaxOfLanes(FloatTag(), r));
}
#undef HAIR_BINARY

HWY_INLINE bool any(Mask m) {
  bool r = false;
  HAIR_PARTS(r |= !hn::AllFalse(FloatTag(), m.part[p]))
  return r;
}
HWY_INLINE bool all(Mask m) {
  bool r = true;
  HAIR_PARTS(r &= hn::AllTrue(FloatTag(), m.part[p]))
  return r;
}
/// Bit l is lane l.
HWY_INLINE std::uint32_t bits(Mask m) {
  std::uint32_t r = 0;
  HAIR_PARTS(std::uint8_t b[8] = {}; hn::StoreMaskBits(FloatTag(), m.part[p], b);
             r |= (std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8) << (p * kPerPart))
  return r;
}
/// Lanes 0 to n - 1.
HWY_INLINE Mask firstLanes(std::size_t n) {
  Mask r;
  HAIR_PARTS(r.part[p] = hn::FirstN(FloatTag(), n > p * kPerPart ? n - p * kPerPart : 0))
  return r;
}
HWY_INLINE Mask none() { return firstLanes(0); }
/// 0, 1, 2 ... 15.
HWY_INLINE Ints laneNumbers() {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::Iota(IntTag(), static_cast<std::int32_t>(p * kPerPart)))
  return r;
}

HWY_INLINE Floats toFloats(Ints v) {
  Floats r;
  HAIR_PARTS(r.part[p] = hn::ConvertTo(FloatTag(), v.part[p]))
  return r;
}
/// Towards zero; |v| below 2^31.
HWY_INLINE Ints truncate(Floats v) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::ConvertTo(IntTag(), v.part[p]))
  return r;
}
HWY_INLINE Ints floorToInt(Floats v) {
  const Ints whole = truncate(v);
  return whole - select(v < toFloats(whole), Ints(1), Ints(0));
}
template <int kBits>
HWY_INLINE Ints shiftLeft(Ints v) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::ShiftLeft<kBits>(v.part[p]))
  return r;
}
/// Arithmetic: negative numbers stay negative.
template <int kBits>
HWY_INLINE Ints shiftRight(Ints v) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::ShiftRight<kBits>(v.part[p]))
  return r;
}
HWY_INLINE Floats asFloats(Ints v) {
  Floats r;
  HAIR_PARTS(r.part[p] = hn::BitCast(FloatTag(), v.part[p]))
  return r;
}
HWY_INLINE Ints asInts(Floats v) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::BitCast(IntTag(), v.part[p]))
  return r;
}

/// from[index], each lane its own.
HWY_INLINE Floats gather(const float* from, Ints index) {
  Floats r;
  HAIR_PARTS(r.part[p] = hn::GatherIndex(FloatTag(), from, index.part[p]))
  return r;
}
HWY_INLINE Ints gather(const std::int32_t* from, Ints index) {
  Ints r;
  HAIR_PARTS(r.part[p] = hn::GatherIndex(IntTag(), from, index.part[p]))
  return r;
}
HWY_INLINE Ints gather(const std::uint32_t* from, Ints index) {
  return gather(reinterpret_cast<const std::int32_t*>(from), index);
}
/// Writes the lanes of m one after another; returns how many. Up to kLanes values past them may be
/// overwritten.
HWY_INLINE std::size_t compress(Ints v, Mask m, std::int32_t* to) {
  std::size_t n = 0;
  HAIR_PARTS(n += hn::CompressStore(v.part[p], hn::RebindMask(IntTag(), m.part[p]), IntTag(),
                                    to + n))
  return n;
}

/// exp(-x) for x >= 0: the bits of expMinusApproximate.
HWY_INLINE Floats expMinusApproximate(Floats x) {
  x = min(x, Floats(87.0f));
  const Floats n = (x * 1.44269504f + 12582912.0f) - 12582912.0f;
  const Floats r = (x - n * 0.693359375f) + n * 2.12194440e-4f;
  Floats e = 1.9841270e-4f;
  e = e * -r + 1.3888889e-3f;
  e = e * -r + 8.3333333e-3f;
  e = e * -r + 4.1666667e-2f;
  e = e * -r + 1.6666667e-1f;
  e = e * -r + 0.5f;
  e = e * (r * r) - r + 1.0f;
  const Ints exponent = shiftLeft<23>(Ints(127) - truncate(n));
  return min(e * asFloats(exponent), Floats(1.0f));
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

HWY_INLINE void store(Vec3 v, LaneVec3& to) { store(v.x, to.x), store(v.y, to.y), store(v.z, to.z); }
/// Sixteen xyz one after another.
HWY_INLINE Vec3 loadPoints(const glm::vec3* from) {
  Vec3 r;
  const float* xyz = &from->x;
  HAIR_PARTS(hn::LoadInterleaved3(FloatTag(), xyz + 3 * p * kPerPart, r.x.part[p], r.y.part[p],
                                  r.z.part[p]))
  return r;
}
HWY_INLINE void storePoints(Vec3 v, glm::vec3* to) {
  float* xyz = &to->x;
  HAIR_PARTS(hn::StoreInterleaved3(v.x.part[p], v.y.part[p], v.z.part[p], FloatTag(),
                                   xyz + 3 * p * kPerPart))
}

HWY_INLINE Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Vec3 operator*(Floats s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
HWY_INLINE Floats dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Floats length(Vec3 a) { return sqrt(dot(a, a)); }
HWY_INLINE Vec3 select(Mask m, Vec3 yes, Vec3 no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
HWY_INLINE Vec3 rotate(const glm::mat3& m, Vec3 v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}

#undef HAIR_PARTS

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

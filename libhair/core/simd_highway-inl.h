// The lanes of simd-inl.h, which alone includes this, by Google Highway: on registers of eight or
// sixteen floats. (On those of four a kernel would take the compiler minutes.)

using FloatTag = hn::CappedTag<float, kLanes>;
using IntTag = hn::RebindToSigned<FloatTag>;
/// Vectors of the CPU that make up sixteen lanes: one with AVX-512, two with AVX2.
inline constexpr std::size_t kPerPart = hn::MaxLanes(FloatTag());
inline constexpr std::size_t kParts = kLanes / kPerPart;

#define HAIR_EACH_PART for (std::size_t p = 0; p < kParts; ++p)

/// One truth value per lane.
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
/// a < b ? a : b and a > b ? a : b, so b where one is NaN, or both are zeros.
// Just what these instructions do.
HAIR_BINARY(Floats, min, Min);
HAIR_BINARY(Floats, max, Max);
/// The lesser of unsigned integers.
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
  // ConvertTo would first check for numbers that are too large.
#if HWY_ARCH_X86 && HWY_MAX_BYTES == 64
  HAIR_EACH_PART r.part[p] = hn::VFromD<IntTag>{_mm512_cvttps_epi32(v.part[p].raw)};
#elif HWY_ARCH_X86
  HAIR_EACH_PART r.part[p] = hn::VFromD<IntTag>{_mm256_cvttps_epi32(v.part[p].raw)};
#else
  HAIR_EACH_PART r.part[p] = hn::ConvertTo(IntTag(), v.part[p]);
#endif
  return r;
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
/// from[index] and from[index + 1].
struct Pairs {
  Floats first, second;
};
HWY_INLINE Pairs gatherPairs(const float* from, Ints index) {
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
  HAIR_EACH_PART r.part[p] =
      hn::ConcatEven(FloatTag(), partOf(a, b, 2 * p + 1), partOf(a, b, 2 * p));
  return r;
}
/// Lanes 1, 3, 5 ... of a, then those of b.
HWY_INLINE Floats oddLanes(Floats a, Floats b) {
  Floats r;
  HAIR_EACH_PART r.part[p] =
      hn::ConcatOdd(FloatTag(), partOf(a, b, 2 * p + 1), partOf(a, b, 2 * p));
  return r;
}
/// Sixteen xyz one after another.
HWY_INLINE void loadPoints(const float* xyz, Floats& x, Floats& y, Floats& z) {
  HAIR_EACH_PART hn::LoadInterleaved3(FloatTag(), xyz + 3 * p * kPerPart, x.part[p], y.part[p],
                                      z.part[p]);
}
HWY_INLINE void storePoints(Floats x, Floats y, Floats z, float* xyz) {
  HAIR_EACH_PART hn::StoreInterleaved3(x.part[p], y.part[p], z.part[p], FloatTag(),
                                       xyz + 3 * p * kPerPart);
}

#undef HAIR_EACH_PART

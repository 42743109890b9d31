// The lanes of simd-inl.h, which alone includes this, for registers of four floats or none: by the
// vector extensions of GCC and Clang, which lower on any CPU. Other operations are calls, which
// avoids sixteen times the code.

/// One truth value per lane.
struct Mask {
  LaneMask v;
};

struct Ints {
  LaneMask v;
  Ints() = default;
  explicit Ints(LaneMask all) : v(all) {}
  Ints(std::int32_t all) : v(LaneMask{} + all) {}
};

struct Floats {
  Lanes v;
  Floats() = default;
  Floats(float all) : v(Lanes{} + all) {}
  /// From storage.
  Floats(const Lanes& all) : v(all) {}
};

/// Memory of sixteen values, at any address.
inline Floats loadFloats(const float* from) {
  Floats r;
  std::memcpy(&r.v, from, sizeof r.v);
  return r;
}
inline Ints loadInts(const std::int32_t* from) {
  Ints r;
  std::memcpy(&r.v, from, sizeof r.v);
  return r;
}
inline void store(const Floats& v, float* to) {
  std::memcpy(to, &v.v, sizeof v.v);
}
inline void store(const Ints& v, std::int32_t* to) {
  std::memcpy(to, &v.v, sizeof v.v);
}
inline void store(const Floats& v, Lanes& to) {
  to = v.v;
}

// NOLINTBEGIN(bugprone-macro-parentheses): an operator stands alone
#define HAIR_BINARY(Type, Result, name, op)          \
  inline Result name(const Type& a, const Type& b) { \
    return Result{a.v op b.v};                       \
  }                                                  \
  static_assert(true)
// NOLINTEND(bugprone-macro-parentheses)
HAIR_BINARY(Floats, Floats, operator+, +);
HAIR_BINARY(Floats, Floats, operator-, -);
HAIR_BINARY(Floats, Floats, operator*, *);
HAIR_BINARY(Floats, Floats, operator/, /);
HAIR_BINARY(Ints, Ints, operator&, &);
HAIR_BINARY(Ints, Ints, operator|, |);
HAIR_BINARY(Mask, Mask, operator&, &);
HAIR_BINARY(Mask, Mask, operator|, |);
HAIR_BINARY(Floats, Mask, operator<, <);
HAIR_BINARY(Floats, Mask, operator<=, <=);
HAIR_BINARY(Floats, Mask, operator>, >);
HAIR_BINARY(Floats, Mask, operator>=, >=);
HAIR_BINARY(Floats, Mask, operator==, ==);
HAIR_BINARY(Ints, Mask, operator<, <);
HAIR_BINARY(Ints, Mask, operator>, >);
HAIR_BINARY(Ints, Mask, operator==, ==);
#undef HAIR_BINARY

// Signed overflow is undefined in C++, but registers wrap around.
using Unsigned [[gnu::vector_size(64)]] = std::uint32_t;
inline Ints operator+(const Ints& a, const Ints& b) {
  return Ints(reinterpret_cast<LaneMask>(reinterpret_cast<Unsigned>(a.v) +
                                         reinterpret_cast<Unsigned>(b.v)));
}
inline Ints operator-(const Ints& a, const Ints& b) {
  return Ints(reinterpret_cast<LaneMask>(reinterpret_cast<Unsigned>(a.v) -
                                         reinterpret_cast<Unsigned>(b.v)));
}
inline Ints operator*(const Ints& a, const Ints& b) {
  return Ints(reinterpret_cast<LaneMask>(reinterpret_cast<Unsigned>(a.v) *
                                         reinterpret_cast<Unsigned>(b.v)));
}

inline Floats operator-(const Floats& a) {
  return Floats(-a.v);
}
inline Mask operator!(const Mask& m) {
  return {~m.v};
}
inline Floats asFloats(const Ints& v) {
  return Floats(reinterpret_cast<Lanes>(v.v));
}
inline Ints asInts(const Floats& v) {
  return Ints(reinterpret_cast<LaneMask>(v.v));
}
inline Ints select(const Mask& m, const Ints& yes, const Ints& no) {
  return Ints((m.v & yes.v) | (~m.v & no.v));
}
inline Floats select(const Mask& m, const Floats& yes, const Floats& no) {
  return asFloats(select(m, asInts(yes), asInts(no)));
}
/// a < b ? a : b and a > b ? a : b, so b where one is NaN, or both are zeros.
inline Floats min(const Floats& a, const Floats& b) {
  return select(a < b, a, b);
}
inline Floats max(const Floats& a, const Floats& b) {
  return select(a > b, a, b);
}
inline Ints min(const Ints& a, const Ints& b) {
  return select(a < b, a, b);
}
inline Ints max(const Ints& a, const Ints& b) {
  return select(a > b, a, b);
}
/// The lesser of unsigned integers.
inline Ints minUnsigned(const Ints& a, const Ints& b) {
  const LaneMask sign = LaneMask{} + std::numeric_limits<std::int32_t>::min();
  return select(Ints(a.v ^ sign) < Ints(b.v ^ sign), a, b);
}
[[gnu::noinline]] inline Floats sqrt(const Floats& a) {
  Floats r;
  for (std::size_t l = 0; l < kLanes; ++l) r.v[l] = std::sqrt(a.v[l]);
  return r;
}
inline Floats toFloats(const Ints& v) {
  return Floats(__builtin_convertvector(v.v, Lanes));
}
/// Towards zero; |v| below 2^31.
inline Ints truncate(const Floats& v) {
  return Ints(__builtin_convertvector(v.v, LaneMask));
}
template <int kBits>
inline Ints shiftLeft(const Ints& v) {
  return Ints(reinterpret_cast<LaneMask>(reinterpret_cast<Unsigned>(v.v) << kBits));
}
/// Arithmetic: negative numbers stay negative.
template <int kBits>
inline Ints shiftRight(const Ints& v) {
  return Ints(v.v >> kBits);
}
inline Floats abs(const Floats& a) {
  return asFloats(asInts(a) & Ints(0x7fffffff));
}

inline bool any(const Mask& m) {
  std::int32_t bits = 0;
  for (std::size_t l = 0; l < kLanes; ++l) bits |= m.v[l];
  return bits != 0;
}
inline bool all(const Mask& m) {
  return !any(!m);
}
/// Bit l is lane l.
[[gnu::noinline]] inline std::uint32_t bits(const Mask& m) {
  std::uint32_t r = 0;
  for (std::size_t l = 0; l < kLanes; ++l) r |= static_cast<std::uint32_t>(m.v[l] & 1) << l;
  return r;
}
/// 0, 1, 2 ... 15.
inline Ints laneNumbers() {
  return Ints(LaneMask{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
}
/// Lanes 0 to n - 1.
inline Mask firstLanes(std::size_t n) {
  return laneNumbers() < Ints(static_cast<std::int32_t>(n));
}
inline Mask none() {
  return {LaneMask{}};
}
/// Lane l where bit l is set.
inline Mask maskOf(std::uint32_t bits) {
  const LaneMask lane = {1,   2,   4,    8,    16,   32,   64,    128,
                         256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
  return {(lane & static_cast<std::int32_t>(bits)) != 0};
}
/// The least and the greatest of the lanes.
[[gnu::noinline]] inline float lowest(const Floats& a) {
  float r = a.v[0];
  for (std::size_t l = 1; l < kLanes; ++l) r = a.v[l] < r ? a.v[l] : r;
  return r;
}
[[gnu::noinline]] inline float highest(const Floats& a) {
  float r = a.v[0];
  for (std::size_t l = 1; l < kLanes; ++l) r = a.v[l] > r ? a.v[l] : r;
  return r;
}

/// from[index], each lane its own.
[[gnu::noinline]] inline Floats gather(const float* from, const Ints& index) {
  Floats r;
  for (std::size_t l = 0; l < kLanes; ++l) r.v[l] = from[index.v[l]];
  return r;
}
[[gnu::noinline]] inline Ints gather(const std::int32_t* from, const Ints& index) {
  Ints r;
  for (std::size_t l = 0; l < kLanes; ++l) r.v[l] = from[index.v[l]];
  return r;
}
/// from[index] and from[index + 1].
struct Pairs {
  Floats first, second;
};
inline Pairs gatherPairs(const float* from, const Ints& index) {
  return {gather(from, index), gather(from + 1, index)};
}
/// Writes the lanes of m one after another; returns how many. Up to kLanes values past them may be
/// overwritten.
[[gnu::noinline]] inline std::size_t compress(const Ints& v, const Mask& m, std::int32_t* to) {
  std::size_t n = 0;
  for (std::size_t l = 0; l < kLanes; ++l) {
    to[n] = v.v[l];
    n += m.v[l] ? 1 : 0;
  }
  return n;
}
/// Lanes 0, 2, 4 ... of a, then those of b.
[[gnu::noinline]] inline Floats evenLanes(const Floats& a, const Floats& b) {
  Floats r;
  for (std::size_t l = 0; l < kLanes / 2; ++l)
    r.v[l] = a.v[2 * l], r.v[l + kLanes / 2] = b.v[2 * l];
  return r;
}
/// Lanes 1, 3, 5 ... of a, then those of b.
[[gnu::noinline]] inline Floats oddLanes(const Floats& a, const Floats& b) {
  Floats r;
  for (std::size_t l = 0; l < kLanes / 2; ++l)
    r.v[l] = a.v[2 * l + 1], r.v[l + kLanes / 2] = b.v[2 * l + 1];
  return r;
}
/// Sixteen xyz one after another.
[[gnu::noinline]] inline void loadPoints(const float* xyz, Floats& x, Floats& y, Floats& z) {
  for (std::size_t l = 0; l < kLanes; ++l)
    x.v[l] = xyz[3 * l], y.v[l] = xyz[3 * l + 1], z.v[l] = xyz[3 * l + 2];
}
[[gnu::noinline]] inline void storePoints(const Floats& x, const Floats& y, const Floats& z,
                                          float* xyz) {
  for (std::size_t l = 0; l < kLanes; ++l)
    xyz[3 * l] = x.v[l], xyz[3 * l + 1] = y.v[l], xyz[3 * l + 2] = z.v[l];
}

#pragma once

#include <cmath>
#include <cstdint>

namespace hair {

/// Eight strands side by side: one float of each. GCC's and Clang's vector extension, which every
/// CPU has a lowering for; the operators + - * / and comparisons come with it.
/// Rounding is that of the scalar operations, so lanes and scalars give the same bits.
inline constexpr std::size_t kLanes = 8;
using Lanes [[gnu::vector_size(32)]] = float;
using LaneMask [[gnu::vector_size(32)]] = std::int32_t;

inline Lanes lanes(float v) {
  return Lanes{v, v, v, v, v, v, v, v};
}
inline Lanes min(Lanes a, Lanes b) {
  return a < b ? a : b;
}
inline Lanes max(Lanes a, Lanes b) {
  return a > b ? a : b;
}
inline Lanes sqrt(Lanes a) {
  Lanes r;
  for (std::size_t l = 0; l < kLanes; ++l) r[l] = std::sqrt(a[l]);
  return r;
}
inline bool any(LaneMask m) {
  std::int32_t bits = 0;
  for (std::size_t l = 0; l < kLanes; ++l) bits |= m[l];
  return bits != 0;
}

/// Eight vectors side by side.
struct LaneVec3 {
  Lanes x, y, z;
};

inline LaneVec3 operator+(LaneVec3 a, LaneVec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline LaneVec3 operator-(LaneVec3 a, LaneVec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline LaneVec3 operator*(Lanes s, LaneVec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(LaneVec3 a, LaneVec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Lanes length(LaneVec3 a) {
  return sqrt(dot(a, a));
}
inline LaneVec3 select(LaneMask m, LaneVec3 a, LaneVec3 b) {
  return {m ? a.x : b.x, m ? a.y : b.y, m ? a.z : b.z};
}

}  // namespace hair

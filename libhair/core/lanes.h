#pragma once

#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

namespace hair {

/// Sixteen strands side by side: one float of each. GCC's and Clang's vector extension, which every
/// CPU has a lowering for; the operators + - * / and comparisons come with it.
/// Rounding is that of the scalar operations, so lanes and scalars give the same bits.
inline constexpr std::size_t kLanes = 16;
using Lanes [[gnu::vector_size(64)]] = float;
using LaneMask [[gnu::vector_size(64)]] = std::int32_t;

inline Lanes lanes(float v) {
  return Lanes{} + v;
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

/// Sixteen vectors side by side.
struct alignas(64) LaneVec3 {
  Lanes x{}, y{}, z{};
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
inline LaneVec3 cross(LaneVec3 a, LaneVec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Lanes length(LaneVec3 a) {
  return sqrt(dot(a, a));
}
/// The same vector in every lane.
inline LaneVec3 broadcast(glm::vec3 v) {
  return {lanes(v.x), lanes(v.y), lanes(v.z)};
}
inline glm::vec3 lane(const LaneVec3& v, std::size_t l) {
  return {v.x[l], v.y[l], v.z[l]};
}
inline void setLane(LaneVec3& v, std::size_t l, glm::vec3 value) {
  v.x[l] = value.x, v.y[l] = value.y, v.z[l] = value.z;
}
inline LaneVec3 rotate(const glm::mat3& m, LaneVec3 v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}

/// A vector v at a right angle to `from`, carried along as `from` turns into `to` (both unit) by
/// the shortest rotation; see transport() in transform.h.
inline LaneVec3 transportNormal(LaneVec3 v, LaneVec3 from, LaneVec3 to) {
  const LaneVec3 h = from + to;
  return v - (2.0f * dot(v, to) / max(dot(h, h), lanes(1e-12f))) * h;
}
inline LaneVec3 select(LaneMask m, LaneVec3 a, LaneVec3 b) {
  return {m ? a.x : b.x, m ? a.y : b.y, m ? a.z : b.z};
}

}  // namespace hair

#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Sixteen strands side by side, one float of each: how what is simulated is stored. GCC's and
/// Clang's vector extension; the operators + - * / and comparisons come with it, and round as
/// scalars do. What is fast is a kernel (simd-inl.h).
inline constexpr std::size_t kLanes = 16;
/// Sixteen floats, of one quantity of sixteen strands.
using Lanes [[gnu::vector_size(64)]] = float;
/// Sixteen answers of a comparison: -1 where it holds, 0 elsewhere.
using LaneMask [[gnu::vector_size(64)]] = std::int32_t;

// GCC warns that vectors are passed in other registers where AVX-512 is enabled. These are inlined.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
/// The same value in all lanes.
inline Lanes lanes(float v) {
  return Lanes{} + v;
}
/// The larger of the two, lane by lane.
inline Lanes max(Lanes a, Lanes b) {
  return a > b ? a : b;
}
#pragma GCC diagnostic pop

/// Sixteen vectors side by side.
struct alignas(64) LaneVec3 {
  Lanes x{},  ///< sixteen x
      y{},    ///< sixteen y
      z{};    ///< sixteen z
};

/// The vector in lane l, [0, kLanes).
inline glm::vec3 lane(const LaneVec3& v, std::size_t l) {
  return {v.x[l], v.y[l], v.z[l]};
}
/// Puts a vector into lane l, [0, kLanes).
inline void setLane(LaneVec3& v, std::size_t l, glm::vec3 value) {
  v.x[l] = value.x, v.y[l] = value.y, v.z[l] = value.z;
}

}  // namespace hair

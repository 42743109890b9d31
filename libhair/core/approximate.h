#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace hair {

/// As plain arithmetic: no branch and no call, so that a loop of it vectorises on every CPU and
/// rounds the same everywhere; simd-inl.h has it in lanes, with the same bits.
///
/// exp(-x) for x >= 0; at most 1, exactly 1 at 0. The product x · log2 e is split in two parts, so
/// that the relative error stays below 3e-7 while the result is above 1e-30.
inline float expMinusApproximate(float x) {
  x = std::min(x, 87.0f);
  const float n = (x * 1.44269504f + 12582912.0f) - 12582912.0f;
  // r = x - n ln 2, in [-0.35, 0.35]; the first part of ln 2 has few bits: n times it is exact.
  const float r = (x - n * 0.693359375f) + n * 2.12194440e-4f;
  float p = 1.9841270e-4f;
  p = p * -r + 1.3888889e-3f;
  p = p * -r + 8.3333333e-3f;
  p = p * -r + 4.1666667e-2f;
  p = p * -r + 1.6666667e-1f;
  p = p * -r + 0.5f;
  p = p * (r * r) - r + 1.0f;
  const auto exponent = static_cast<std::uint32_t>(127 - static_cast<std::int32_t>(n)) << 23;
  return std::min(p * std::bit_cast<float>(exponent), 1.0f);
}

}  // namespace hair

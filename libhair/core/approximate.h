#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace hair {

/// Exponential and logarithm as plain arithmetic: no branch and no call, so that a loop of them
/// vectorises on every CPU and rounds the same everywhere.

/// 2^x for x in [-126, 127]; relative error below 1e-7 beyond the rounding of x itself; 1 at 0.
/// x outside is clamped.
inline float exp2Approximate(float x) {
  x = std::min(std::max(x, -126.0f), 127.0f);
  // x = n + f with f in [-1/2, 1/2]: adding 1.5 · 2^23 rounds to an integer.
  const float n = (x + 12582912.0f) - 12582912.0f;
  const float f = x - n;
  // Taylor polynomial of 2^f; the first term left out is below 2e-9.
  float p = 1.5252734e-5f;
  p = p * f + 1.5403530e-4f;
  p = p * f + 1.3333558e-3f;
  p = p * f + 9.6181291e-3f;
  p = p * f + 5.5504109e-2f;
  p = p * f + 2.4022651e-1f;
  p = p * f + 6.9314718e-1f;
  p = p * f + 1.0f;
  const auto exponent = static_cast<std::uint32_t>(static_cast<std::int32_t>(n) + 127) << 23;
  return p * std::bit_cast<float>(exponent);
}

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

/// log2 x for normal x > 0; absolute error below 1e-6 (relative to the larger of 1 and |log2 x|).
inline float log2Approximate(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  // x = 2^n m with m in [sqrt(1/2), sqrt 2).
  const std::int32_t n = static_cast<std::int32_t>(bits - 0x3f3504f3u) >> 23;
  const float m = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(n) << 23));
  // log m = 2 artanh(z), z = (m - 1) / (m + 1), |z| <= 0.172.
  const float z = (m - 1.0f) / (m + 1.0f);
  const float zz = z * z;
  const float series = 1.0f + zz * (0.33333333f + zz * (0.2f + zz * (0.14285714f + zz * 0.1111f)));
  return static_cast<float>(n) + 2.88539008f * z * series;
}

/// x^y for x in [0, 1], y >= 0; 0 where x is 0.
inline float powApproximate(float x, float y) {
  const float safe = std::max(x, 1e-30f);
  const float p = exp2Approximate(y * log2Approximate(safe));
  return x <= 0.0f ? 0.0f : p;
}

}  // namespace hair

#include <libhair/shade/srgb.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hair {

float srgbFromLinear(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

SrgbTable::SrgbTable() {
  const std::uint32_t start = std::bit_cast<std::uint32_t>(kLeast);
  const int count = kOctaves << kMantissaBits;
  for (int b = 0; b < count; ++b) {
    // The middle of the range of floats with these leading bits.
    const auto low = static_cast<std::uint32_t>(b) << (23 - kMantissaBits);
    const float x = std::bit_cast<float>(start + low + (1u << (22 - kMantissaBits)));
    bytes_[b] = static_cast<std::int32_t>(std::lround(255.0f * srgbFromLinear(x)));
  }
  bytes_[0] = 0;
  bytes_[count] = 255;
}

const SrgbTable& SrgbTable::get() {
  static const SrgbTable table;
  return table;
}

}  // namespace hair

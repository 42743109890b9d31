#pragma once

#include <bit>
#include <cstdint>

namespace hair {

/// Linear value to sRGB byte (IEC 61966-2-1), by a table indexed with the float's leading bits.
/// Clamps to [0, 1]; within 0.65 of the exact value.
class SrgbTable {
 public:
  /// The shared table, built on first use.
  static const SrgbTable& get();

  /// The byte for `linear`; NaN gives 0.
  std::uint8_t operator()(float linear) const {
    // NaN compares false and becomes kLeast: black.
    const float x = linear > kLeast ? (linear < 1.0f ? linear : 1.0f) : kLeast;
    return static_cast<std::uint8_t>(
        bytes_[(std::bit_cast<std::uint32_t>(x) - std::bit_cast<std::uint32_t>(kLeast)) >>
               (23 - kMantissaBits)]);
  }

  /// The table, for vectorised look-ups by the indices of operator().
  const std::int32_t* bytes() const { return bytes_; }
  /// Leading bits of the mantissa in the index.
  static constexpr int kMantissaBits = 9;
  static constexpr float kLeast = 0x1p-13f;  ///< 0.4 of a byte step: encoded as 0

 private:
  SrgbTable();

  static constexpr int kOctaves = 13;
  // 32 bits an entry, for gathers.
  std::int32_t bytes_[(kOctaves << kMantissaBits) + 1];
};

/// The exact transfer function, [0, 1] to [0, 1].
float srgbFromLinear(float linear);

}  // namespace hair

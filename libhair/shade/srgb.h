#pragma once

#include <bit>
#include <cstdint>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Linear light to the sRGB byte that shows it (IEC 61966-2-1), by a table of the float's leading
/// bits. 0 and below gives 0, 1 and above 255; elsewhere within 0.65 of the exact value.
class SrgbTable {
 public:
  /// The one table, made at first use.
  static const SrgbTable& get();

  /// The byte for `linear`; NaN gives 0.
  std::uint8_t operator()(float linear) const {
    // NaN compares false and becomes kLeast: black.
    const float x = linear > kLeast ? (linear < 1.0f ? linear : 1.0f) : kLeast;
    return static_cast<std::uint8_t>(
        bytes_[(std::bit_cast<std::uint32_t>(x) - std::bit_cast<std::uint32_t>(kLeast)) >>
               (23 - kMantissaBits)]);
  }

  /// For those who look up many at once: as operator() does.
  const std::int32_t* bytes() const { return bytes_; }
  /// Leading bits of the mantissa that the table tells apart.
  static constexpr int kMantissaBits = 9;
  static constexpr float kLeast = 0x1p-13f;  ///< 0.4 of the step from 0 to 1: shown as 0

 private:
  SrgbTable();

  static constexpr int kOctaves = 13;
  // As wide as what is gathered.
  std::int32_t bytes_[(kOctaves << kMantissaBits) + 1];
};

/// The exact curve, [0, 1] to [0, 1].
float srgbFromLinear(float linear);

}  // namespace hair

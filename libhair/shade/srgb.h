#pragma once

#include <cstdint>

namespace hair {

/// Linear light to the sRGB byte that shows it (IEC 61966-2-1), by a table of the float's leading
/// bits. 0 and below gives 0, 1 and above 255; elsewhere within 0.65 of the exact value.
class SrgbTable {
 public:
  /// The one table, made at first use.
  static const SrgbTable& get();

  std::uint8_t operator()(float linear) const;

 private:
  SrgbTable();

  static constexpr int kMantissaBits = 9;
  static constexpr int kOctaves = 13;  // 2^-13 and below is shown as 0
  std::uint8_t bytes_[(kOctaves << kMantissaBits) + 1];
};

/// The exact curve, [0, 1] to [0, 1].
float srgbFromLinear(float linear);

}  // namespace hair

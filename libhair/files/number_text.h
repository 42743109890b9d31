#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

namespace hair {

/// The finite float nearest to a decimal number; nullopt if the word is not a number or overflows.
/// Rounds once, not twice through a double, so that the shortest digits of a float round-trip.
/// Underflow (1e-50) gives the nearest float, mostly zero.
inline std::optional<float> floatFromText(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  float value = 0;
  auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) {
    double wide = 0;
    error = std::from_chars(word.data(), word.data() + word.size(), wide).ec;
    if (error == std::errc::result_out_of_range) return std::nullopt;
    value = static_cast<float>(wide);
  }
  if (error != std::errc() || stop != word.data() + word.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace hair

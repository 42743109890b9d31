// Parses and prints text that states units and axes.
#include <libhair/files/file_units.h>

#include <charconv>
#include <optional>

#include <libhair/files/number_text.h>

namespace hair {

namespace {

constexpr std::string_view kStart = "libhair: ", kMetres = "metres, ", kUnits = " m a unit, ";

}  // namespace

std::string unitsText(float scale, UpAxis up) {
  std::string words(kStart);
  if (scale == 1) {
    words += kMetres;
  } else {
    char digits[32];
    words.append(digits, std::to_chars(digits, digits + sizeof digits, scale).ptr);
    words += kUnits;
  }
  return words += upAxisMeaning(up);
}

bool unitsFromText(std::string_view words, float& scale, UpAxis& up) {
  if (!words.starts_with(kStart)) return false;
  words.remove_prefix(kStart.size());
  float stated = 1;
  if (words.starts_with(kMetres)) {
    words.remove_prefix(kMetres.size());
  } else {
    const std::size_t end = words.find(kUnits);
    if (end == std::string_view::npos) return false;
    const std::optional<float> number = floatFromText(words.substr(0, end));
    if (!number || !(*number > 0)) return false;
    stated = *number;
    words.remove_prefix(end + kUnits.size());
  }
  for (const auto& axis : wordsOf(UpAxis{})) {
    if (axis.value == UpAxis::AsFile || !words.starts_with(upAxisMeaning(axis.value))) continue;
    scale = stated;
    up = axis.value;
    return true;
  }
  return false;
}

}  // namespace hair

// Units and axes of files: parses and prints them, and converts to the library's.
#include <libhair/files/file_units.h>

#include <array>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/number_text.h>

namespace hair {

namespace {

constexpr std::string_view kStart = "libhair: ", kMetres = "metres, ", kUnits = " m a unit, ";

// Rows: the library's x, y, z as combinations of the file's. Entries 0, 1, -1: exact in floats.
glm::mat3 libraryFromFile(UpAxis up) {
  const auto rows = [](glm::vec3 x, glm::vec3 y, glm::vec3 z) {
    return glm::transpose(glm::mat3(x, y, z));
  };
  switch (up) {
    case UpAxis::Z:
      return rows({-1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    case UpAxis::ZBack:
      return rows({1, 0, 0}, {0, 0, 1}, {0, -1, 0});
    case UpAxis::X:
      return rows({0, -1, 0}, {1, 0, 0}, {0, 0, 1});
    case UpAxis::YDown:
      return rows({-1, 0, 0}, {0, -1, 0}, {0, 0, 1});
    case UpAxis::AsFile:
    case UpAxis::Y:
      break;
  }
  return glm::mat3(1);
}

}  // namespace

UpAxis upAxisFromText(std::string_view text) {
  for (const auto& word : wordsOf(UpAxis{}))
    if (text == word.word) return word.value;
  throw Error(hair::text("up axis '", text, "': choose one of ", allWords<UpAxis>()));
}

std::string_view upAxisMeaning(UpAxis up) {
  switch (up) {
    case UpAxis::AsFile:
      return "the format's axes";
    case UpAxis::Y:
      return "+Y up, +Z face";
    case UpAxis::Z:
      return "+Z up, +Y face";
    case UpAxis::ZBack:
      return "+Z up, -Y face";
    case UpAxis::X:
      return "+X up, +Z face";
    case UpAxis::YDown:
      return "-Y up, +Z face";
  }
  return "?";
}

void convertUnits(std::span<glm::vec3> points, float scale, UpAxis up) {
  const glm::mat3 rotation = libraryFromFile(up);
  for (glm::vec3& p : points) p = scale * (rotation * p);
}

void convertUnitsBack(std::span<glm::vec3> points, float scale, UpAxis up) {
  const glm::mat3 rotation = glm::transpose(libraryFromFile(up));
  for (glm::vec3& p : points) p = rotation * (p / scale);
}

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

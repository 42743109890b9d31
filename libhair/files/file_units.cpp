// Units and axes of files: converts to the library's and back.
#include <libhair/core/error.h>
#include <libhair/files/strand_file.h>

namespace hair {

namespace {

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

}  // namespace hair

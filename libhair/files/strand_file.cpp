#include <libhair/files/strand_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/data_file.h>
#include <libhair/files/hair_file.h>
#include <libhair/files/tfx_file.h>

namespace hair {

namespace {

// A .hair file that starts its info text with this says what Yuksel's format cannot.
constexpr std::string_view kMetresYUp = "libhair: metres, +Y up, +Z face";
constexpr float kYukselScale = 0.00465f;  // of straight.hair: a head of 9.5 cm radius

constexpr std::array<std::pair<std::string_view, UpAxis>, 6> kUpNames = {{{"file", UpAxis::AsFile},
                                                                          {"y", UpAxis::Y},
                                                                          {"z", UpAxis::Z},
                                                                          {"z-back", UpAxis::ZBack},
                                                                          {"x", UpAxis::X},
                                                                          {"-y", UpAxis::MinusY}}};

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
    case UpAxis::MinusY:
      return rows({-1, 0, 0}, {0, -1, 0}, {0, 0, 1});
    case UpAxis::AsFile:
    case UpAxis::Y:
      break;
  }
  return glm::mat3(1);
}

// Moves what belongs to the kept strands to the front; nothing ever moves towards the end.
template <class T>
void keepStrands(std::vector<T>& items, const std::vector<std::uint32_t>& first,
                 const std::vector<std::uint32_t>& kept) {
  auto to = items.begin();
  for (std::uint32_t s : kept)
    to = std::copy(items.begin() + first[s], items.begin() + first[s + 1], to);
  items.erase(to, items.end());
}

void keepOffsets(std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& kept) {
  std::vector<std::uint32_t> result = {0};
  for (std::uint32_t s : kept) result.push_back(result.back() + first[s + 1] - first[s]);
  first = std::move(result);
}

}  // namespace

UpAxis upAxisFromText(std::string_view text) {
  for (const auto& [name, up] : kUpNames)
    if (text == name) return up;
  throw Error(hair::text("up axis '", text, "': choose file, y, z, z-back, x or -y"));
}

std::string_view upAxisText(UpAxis up) {
  for (const auto& [name, value] : kUpNames)
    if (up == value) return name;
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

StrandFile readStrands(const std::filesystem::path& file, const ReadOptions& options) {
  require(std::isfinite(options.scale) && options.scale >= 0, "scale of ", options.scale,
          " metres a unit: must be above zero (or 0 for the format's default)");
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));

  StrandFile result;
  if (extension == ".hair") {
    HairFile hair = readHair(file);
    if (!hair.thickness.empty()) result.arrays += ", thickness";
    if (!hair.transparency.empty()) result.arrays += ", transparency";
    if (!hair.colours.empty()) result.arrays += ", colours";
    if (!hair.info.starts_with(kMetresYUp)) {
      result.scale = kYukselScale;
      result.up = UpAxis::Z;
    }
    result.thickness = std::move(hair.thickness);
    result.transparency = std::move(hair.transparency);
    result.colours = std::move(hair.colours);
    result.defaultThickness = hair.defaultThickness;
    result.defaultTransparency = hair.defaultTransparency;
    result.defaultColour = hair.defaultColour;
    result.strands = std::move(hair.strands);
  } else if (extension == ".tfx") {
    TfxFile tfx = readTfx(file);
    result.format = "tfx";
    result.arrays = "points, pinned";
    if (!tfx.strandUv.empty()) result.arrays += ", strand UV";
    result.strands = std::move(tfx.strands);
  } else if (extension == ".data") {
    result.format = "data";
    result.strands = readData(file);
  } else {
    throw Error(text(file.string(), ": unknown format '", extension,
                     "'; strands are read from .hair, .tfx and .data"));
  }
  if (options.scale > 0) result.scale = options.scale;
  if (options.up != UpAxis::AsFile) result.up = options.up;
  if (result.scale != 1 || result.up != UpAxis::Y)
    convertUnits(result.strands.points, result.scale, result.up);
  for (float& t : result.thickness) t *= result.scale;
  result.defaultThickness *= result.scale;
  validate(result.strands, file.string(), 0);
  return result;
}

void writeStrands(const std::filesystem::path& file, StrandView strands) {
  StrandFile whole;
  whole.strands.points.assign(strands.points.begin(), strands.points.end());
  whole.strands.first.assign(strands.first.begin(), strands.first.end());
  writeStrands(file, whole);
}

void writeStrands(const std::filesystem::path& file, const StrandFile& strands) {
  writeHair(file, {.strands = strands.strands,
                   .thickness = strands.thickness,
                   .transparency = strands.transparency,
                   .colours = strands.colours,
                   .defaultThickness = strands.defaultThickness,
                   .defaultTransparency = strands.defaultTransparency,
                   .defaultColour = strands.defaultColour,
                   .info = std::string(kMetresYUp)});
}

std::vector<std::uint32_t> soundStrands(StrandView strands, float minLength,
                                        std::size_t minPoints) {
  std::vector<std::uint32_t> sound;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    if (points.size() >= minPoints && arcLength(points) >= minLength)
      sound.push_back(static_cast<std::uint32_t>(s));
  }
  return sound;
}

std::size_t dropDegenerate(StrandSet& strands, float minLength, std::size_t minPoints) {
  const auto kept = soundStrands(strands, minLength, minPoints);
  const std::size_t dropped = strands.strandCount() - kept.size();
  keepStrands(strands.points, strands.first, kept);
  keepOffsets(strands.first, kept);
  return dropped;
}

std::size_t dropDegenerate(StrandFile& file, float minLength, std::size_t minPoints) {
  const auto kept = soundStrands(file.strands, minLength, minPoints);
  const std::size_t dropped = file.strands.strandCount() - kept.size();
  for (auto* array : {&file.thickness, &file.transparency})
    if (!array->empty()) keepStrands(*array, file.strands.first, kept);
  if (!file.colours.empty()) keepStrands(file.colours, file.strands.first, kept);
  keepStrands(file.strands.points, file.strands.first, kept);
  keepOffsets(file.strands.first, kept);
  return dropped;
}

}  // namespace hair

#include <libhair/files/numpy/npz_strands.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include <libhair/core/error.h>
#include <libhair/files/numpy/npy.h>
#include <libhair/files/numpy/zip.h>
#include <libhair/files/point_cloud.h>
#include <libhair/files/text_reader.h>

namespace hair {

namespace {

// An array's name is the last part of its file's.
std::string shortName(std::string_view name) {
  if (name.ends_with(".npy")) name.remove_suffix(4);
  std::string word(name.substr(name.find_last_of("/: ") + 1));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

std::string shapeText(const NpyArray& array) {
  std::string words = "[";
  for (std::size_t d = 0; d < array.shape.size(); ++d)
    words += text(d > 0 ? ", " : "", array.shape[d]);
  return words + ']';
}

bool holdsPoints(const NpyArray& array) {
  const std::size_t d = array.shape.size();
  return array.isFloat() && (d == 2 || d == 3) && array.shape.back() == 3 && array.size() > 0;
}

// The lower the better.
std::size_t rankOf(const NpyArray& array) {
  constexpr std::string_view kNames[] = {"points", "strand", "hair",   "position", "pos",
                                         "vert",   "xyz",    "curves", "arr_0"};
  const std::string name = shortName(array.name);
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (name.starts_with(kNames[i])) return i;
  // Directions and colours have three numbers too.
  for (const std::string_view other :
       {"color", "colour", "rgb", "normal", "tangent", "dir", "root"})
    if (name.find(other) != std::string::npos) return 100;
  return std::size(kNames);
}

// Offsets [strandCount + 1] of strands in n points, if these numbers can be what says it.
std::optional<std::vector<std::uint32_t>> offsetsFrom(const NpyArray& array, std::size_t n) {
  if (array.isFloat() || array.kind == 'b' || array.shape.size() != 1 || array.size() == 0)
    return {};
  const std::size_t count = array.size();
  std::vector<std::uint32_t> values;
  std::size_t sum = 0;
  bool rising = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = array.item(i);
    if (!(value >= 0) || value > static_cast<double>(n)) return {};
    values.push_back(static_cast<std::uint32_t>(value));
    rising = rising && (i == 0 || values[i] >= values[i - 1]);
    sum += values[i];
  }
  const auto end = static_cast<std::uint32_t>(n);
  std::vector<std::uint32_t> first = {0};
  if (sum == n && !(rising && values[0] == 0 && values.back() == end && count > 1)) {  // counts
    for (const std::uint32_t v : values) first.push_back(first.back() + v);
    return first;
  }
  if (!rising) return {};
  if (count == n && values.back() < end && values.back() - values[0] < end - 1) {  // of every point
    for (std::uint32_t i = 1; i < end; ++i)
      if (values[i] != values[i - 1]) first.push_back(i);
    first.push_back(end);
    return first;
  }
  if (values[0] == 0) {  // offsets
    if (values.back() != end) values.push_back(end);
    return values;
  }
  if (values.back() != end) return {};
  first.insert(first.end(), values.begin(), values.end());  // ends
  return first;
}

// Points of [strands, points, 3]; what is not finite at a strand's end is none.
void takeRows(const std::vector<glm::vec3>& points, std::size_t each, StrandSet& strands) {
  strands.points.reserve(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += each) {
    std::size_t count = each;
    const auto finite = [](glm::vec3 p) {
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    };
    while (count > 0 && !finite(points[begin + count - 1])) --count;
    strands.points.insert(strands.points.end(), points.begin() + static_cast<std::ptrdiff_t>(begin),
                          points.begin() + static_cast<std::ptrdiff_t>(begin + count));
    strands.first.push_back(static_cast<std::uint32_t>(strands.points.size()));
  }
}

// One a point from one a point, a strand, or one for all; empty where they are none of these.
template <class T>
std::vector<T> spread(const std::vector<T>& values, const StrandSet& strands) {
  if (values.size() == strands.pointCount()) return values;
  if (values.size() != strands.strandCount()) return {};
  std::vector<T> all;
  for (std::size_t s = 0; s < values.size(); ++s) all.resize(strands.first[s + 1], values[s]);
  return all;
}

void takeLooks(const NpyArray& array, StrandFile& file, std::vector<std::string>& taken) {
  const std::string name = shortName(array.name);
  const auto has = [&](std::string_view word) { return name.find(word) != std::string::npos; };
  const bool radius = has("radi");
  if (array.isFloat() && (radius || has("width") || has("thickness") || has("diameter")) &&
      file.thickness.empty()) {
    std::vector<float> values = array.floats();
    for (float& v : values) {
      if (!std::isfinite(v)) return;
      if (radius) v *= 2;
    }
    if (values.size() == 1)
      file.defaultThickness = values[0];
    else
      file.thickness = spread(values, file.strands);
    taken.push_back(name);
  } else if ((has("color") || has("colour") || has("rgb")) && !array.shape.empty() &&
             array.shape.back() == 3 && file.colours.empty()) {
    const std::vector<float> values = array.floats();
    const float full = array.kind == 'u' && array.itemBytes == 1 ? 255.0f : 1.0f;
    std::vector<glm::vec3> colours;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      colours.push_back(glm::vec3(values[i], values[i + 1], values[i + 2]) / full);
      if (!std::isfinite(colours.back().x + colours.back().y + colours.back().z)) return;
    }
    file.colours = spread(colours, file.strands);
    taken.push_back(name);
  }
}

StrandFile strandsOf(const std::vector<NpyArray>& arrays, std::string_view name,
                     std::uint32_t pointsPerStrand) {
  const NpyArray* points = nullptr;
  std::string all;
  for (const NpyArray& array : arrays) {
    all += text(all.empty() ? "" : ", ", TextReader::shown(shortName(array.name)), ' ',
                shapeText(array));
    if (!holdsPoints(array)) continue;
    // Of equal names a strand a row says more; then the larger.
    const auto key = [](const NpyArray& a) {
      return std::tuple(rankOf(a), a.shape.size() == 3 ? 0 : 1, ~a.size());
    };
    if (!points || key(array) < key(*points)) points = &array;
  }
  require(points != nullptr, name,
          ": no array of points, floats [strands, points, 3] or [n, 3]: ", all);
  const std::vector<float> numbers = points->floats();
  std::vector<glm::vec3> vertices(numbers.size() / 3);
  require(vertices.size() <= 0xffffffffu, name, ": more than 2^32 - 1 points");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};

  StrandFile file;
  std::vector<std::string> taken = {shortName(points->name)};
  if (points->shape.size() == 3) {
    takeRows(vertices, points->shape[1], file.strands);
  } else {
    const NpyArray* by = nullptr;
    std::optional<std::vector<std::uint32_t>> first;
    // Those that are named for it come first.
    for (const bool named : {true, false})
      for (const NpyArray& array : arrays) {
        const std::string word = shortName(array.name);
        const auto has = [&](std::string_view part) { return word.find(part) != word.npos; };
        const bool fits = has("count") || has("len") || has("num") || has("offset") ||
                          has("first") || has("start") || has("ptr") || has("strand") ||
                          has("split") || has("size") || has("end");
        if (first || pointsPerStrand > 0 || fits != named) continue;
        first = offsetsFrom(array, vertices.size());
        if (first) by = &array;
      }
    if (by) taken.push_back(shortName(by->name));
    file.strands.first =
        first ? std::move(*first) : cloudStrands(vertices, pointsPerStrand, name, file.notes);
    file.strands.points = std::move(vertices);
  }
  for (std::size_t i = 0; i < file.strands.points.size(); ++i) {
    const glm::vec3 p = file.strands.points[i];
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), name, ": ",
            TextReader::shown(taken[0]), ": point ", i, " is not finite");
  }
  for (const NpyArray& array : arrays)
    if (&array != points) takeLooks(array, file, taken);
  if (arrays.size() > 1) {
    std::string words = text("of the arrays ", all, ": ");
    for (std::size_t i = 0; i < taken.size(); ++i)
      words += (i > 0 ? ", " : "") + TextReader::shown(taken[i]);
    file.notes.push_back(words + (taken.size() == 1 ? " is read" : " are read"));
  }
  return file;
}

}  // namespace

StrandFile parseNumpy(std::string_view bytes, std::string_view name,
                      std::uint32_t pointsPerStrand) {
  std::vector<ZipEntry> entries;
  std::vector<NpyArray> arrays;
  const bool packed = bytes.starts_with("PK");
  if (packed) {
    entries = unzip(bytes, name, ".npy");
    require(!entries.empty(), name, ": holds no arrays (.npy)");
    std::string failed;
    for (const ZipEntry& entry : entries) {
      // Text and objects beside the points are no matter.
      try {
        arrays.push_back(parseNpy(entry.bytes, text(name, ": ", TextReader::shown(entry.name))));
      } catch (const Error& e) {
        failed = e.what();
      }
    }
    require(!arrays.empty(), failed);
  } else {
    arrays.push_back(parseNpy(bytes, name));
  }
  StrandFile file = strandsOf(arrays, name, pointsPerStrand);
  file.format = packed ? "npz" : "npy";
  return file;
}

}  // namespace hair

#include <libhair/files/ply_file.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <utility>

#include <libhair/files/byte_reader.h>
#include <libhair/files/edges.h>
#include <libhair/files/file_units.h>
#include <libhair/files/ply_header.h>
#include <libhair/files/point_cloud.h>
#include <libhair/files/text_writer.h>

namespace hair {

namespace {

using Type = PlyHeader::Type;
using Element = PlyHeader::Element;

// Least and largest number of an integer type; of floats no bounds.
std::array<double, 2> rangeOf(Type type) {
  const auto of = [](auto kind) {
    using Limits = std::numeric_limits<decltype(kind)>;
    return std::array{static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max())};
  };
  switch (type) {
    case Type::Int8:
      return of(std::int8_t{});
    case Type::Uint8:
      return of(std::uint8_t{});
    case Type::Int16:
      return of(std::int16_t{});
    case Type::Uint16:
      return of(std::uint16_t{});
    case Type::Int32:
      return of(std::int32_t{});
    case Type::Uint32:
      return of(std::uint32_t{});
    case Type::Float32:
    case Type::Float64:
      break;
  }
  return {-INFINITY, INFINITY};
}

// Numbers as binary files hold them.
class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : in_(bytes, name), swapped_(header.bigEndian) {
    in_.seek(header.bytes, "elements");
  }
  void expectElements(const Element& element) const {
    in_.expectLeft(element.count, element.leastBytes(), element.name);
  }
  void beginElement() {}
  double next(Type type, std::string_view what) {
    switch (type) {
      case Type::Int8:
        return read<std::int8_t>(what);
      case Type::Uint8:
        return read<std::uint8_t>(what);
      case Type::Int16:
        return read<std::int16_t>(what);
      case Type::Uint16:
        return read<std::uint16_t>(what);
      case Type::Int32:
        return read<std::int32_t>(what);
      case Type::Uint32:
        return read<std::uint32_t>(what);
      case Type::Float32:
        return static_cast<double>(read<float>(what));
      case Type::Float64:
        return read<double>(what);
    }
    return 0;
  }
  void expectItems(double count, Type type, std::string_view what) const {
    in_.expectLeft(static_cast<std::size_t>(count), plyTypeBytes(type), what);
  }
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    in_.expect(condition, parts...);
  }

 private:
  template <class T>
  T read(std::string_view what) {
    const T value = in_.read<T>(what);
    if (!swapped_) return value;
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  ByteReader in_;
  bool swapped_;
};

// The same as words: a line an element.
class TextNumbers {
 public:
  explicit TextNumbers(TextReader& in) : in_(in) {}
  void expectElements(const Element& element) const {
    in_.expect(element.count <= in_.left(), element.name, ": ", element.count,
               " are announced but ", in_.left(), " bytes are left (truncated, or a bad count)");
  }
  void beginElement() { in_.expect(in_.nextLine(), "the file ends here (truncated)"); }
  double next(Type type, std::string_view what) {
    const std::string_view word = in_.word();
    in_.expect(!word.empty(), what, ": a number is missing at the end of the line");
    if (type == Type::Float32) return static_cast<double>(in_.toNumber(word, what));
    if (type == Type::Float64) return in_.toDouble(word, what);
    const auto number = static_cast<double>(in_.toInteger(word, what));
    const auto [least, most] = rangeOf(type);
    in_.expect(number >= least && number <= most, what, ": ", word, " is not in ",
               static_cast<long long>(least), " to ", static_cast<long long>(most),
               ", as its type asks");
    return number;
  }
  void expectItems(double, Type, std::string_view) const {}  // each is a word, or an error
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    in_.expect(condition, parts...);
  }

 private:
  TextReader& in_;
};

// Goes through the items of an element; `take` gets each one's single numbers, and before that
// `takeListed` the numbers of lists, with the property that each is of.
template <class Numbers, class Take, class TakeListed>
void readElement(Numbers& in, const Element& element, Take&& take, TakeListed&& takeListed) {
  in.expect(element.count == 0 || !element.properties.empty(), "element ",
            TextReader::shown(element.name), " has no properties");
  in.expectElements(element);
  std::vector<double> values(element.properties.size());
  for (std::size_t i = 0; i < element.count; ++i) {
    in.beginElement();
    for (std::size_t p = 0; p < values.size(); ++p) {
      const PlyHeader::Property& property = element.properties[p];
      if (!property.countType) {
        values[p] = in.next(property.type, property.name);
        continue;
      }
      const double count = in.next(*property.countType, property.name);
      in.expect(count >= 0, property.name, ": a list of ", count, " items");
      in.expectItems(count, property.type, property.name);
      for (double k = 0; k < count; ++k) takeListed(p, in.next(property.type, property.name));
    }
    take(values);
  }
}

template <class Numbers, class Take>
void readElement(Numbers& in, const Element& element, Take&& take) {
  readElement(in, element, take, [](std::size_t, double) {});
}

struct Mesh {
  std::vector<glm::vec3> positions, colours;
  std::vector<float> thickness, transparency;
  std::vector<std::uint32_t> strandOf;  // a number a vertex that is the same along a strand
  std::vector<std::array<std::uint32_t, 2>> edges;
  EdgeChains lines;  // of many vertices each
};

// Elements that join vertices, by the names that programs give them.
bool joinsVertices(const Element& element) {
  constexpr std::string_view kNames[] = {
      "edge",   "edges",  "line",      "lines",   "segment", "segments", "polyline", "curve",
      "curves", "strand", "polylines", "strands", "fiber",   "fibers",   "fibre",    "fibres"};
  return !element.properties.empty() &&
         std::find(std::begin(kNames), std::end(kNames), element.name) != std::end(kNames);
}

// Index of a scalar property in an element; lists of that name are ignored.
int single(const Element& element, std::string_view name) {
  const int at = element.find(name);
  return at >= 0 && !element.properties[static_cast<std::size_t>(at)].countType ? at : -1;
}

// The first of these names that there is.
int firstOf(const Element& element, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (const int at = single(element, name); at >= 0) return at;
  return -1;
}

template <class Numbers>
void readVertices(Numbers& in, const Element& element, Mesh& mesh) {
  const std::array<int, 3> xyz = {single(element, "x"), single(element, "y"), single(element, "z")};
  const std::array<int, 3> rgb = {single(element, "red"), single(element, "green"),
                                  single(element, "blue")};
  const int diameter = firstOf(element, {"thickness", "width", "diameter"});
  const int radius = diameter < 0 ? single(element, "radius") : -1;
  const int strand = firstOf(element, {"strand_id", "strand", "curve_id", "hair_id"});
  const int transparency = single(element, "transparency");
  for (int p : xyz) in.expect(p >= 0, "vertices need numbers x, y and z");
  const bool coloured = rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0;
  readElement(in, element, [&](const std::vector<double>& values) {
    const auto number = [&](int p) {
      const double value = values[static_cast<std::size_t>(p)];
      in.expect(std::abs(value) <= std::numeric_limits<float>::max(), "vertex ",
                mesh.positions.size(), ": ", element.properties[static_cast<std::size_t>(p)].name,
                " is ", value, ", no finite number");
      return static_cast<float>(value);
    };
    const auto channel = [&](int p) {
      // Of an integer type the largest number is full light.
      const PlyHeader::Property& property = element.properties[static_cast<std::size_t>(p)];
      const double full = rangeOf(property.type)[1];
      if (!std::isfinite(full)) return number(p);
      in.expect(number(p) >= 0, "vertex ", mesh.positions.size(), ": ", property.name, " is ",
                number(p), ", below 0");
      return static_cast<float>(values[static_cast<std::size_t>(p)] / full);
    };
    const glm::vec3 position(number(xyz[0]), number(xyz[1]), number(xyz[2]));
    if (coloured) mesh.colours.emplace_back(channel(rgb[0]), channel(rgb[1]), channel(rgb[2]));
    if (diameter >= 0) mesh.thickness.push_back(number(diameter));
    if (radius >= 0) mesh.thickness.push_back(2 * number(radius));
    if (strand >= 0)
      mesh.strandOf.push_back(static_cast<std::uint32_t>(
          std::clamp(values[static_cast<std::size_t>(strand)], 0.0, 4294967295.0)));
    if (transparency >= 0) mesh.transparency.push_back(number(transparency));
    mesh.positions.push_back(position);
  });
}

template <class Numbers>
std::uint32_t vertexNumber(const Numbers& in, double v, std::size_t vertexCount,
                           std::string_view of, std::size_t number) {
  in.expect(v >= 0 && v < static_cast<double>(vertexCount) && v == std::floor(v), of, ' ', number,
            ": vertex ", v, " does not exist (", vertexCount, " vertices)");
  return static_cast<std::uint32_t>(v);
}

// Either a pair of vertices each, or a list of any number.
template <class Numbers>
void readLines(Numbers& in, const Element& element, std::size_t vertexCount, Mesh& mesh) {
  const auto list = std::find_if(element.properties.begin(), element.properties.end(),
                                 [](const PlyHeader::Property& p) { return p.countType; });
  if (list != element.properties.end()) {
    const auto property = static_cast<std::size_t>(list - element.properties.begin());
    auto& [vertices, first] = mesh.lines;
    readElement(
        in, element,
        [&](const std::vector<double>&) {
          if (vertices.size() > first.back())
            first.push_back(static_cast<std::uint32_t>(vertices.size()));
        },
        [&](std::size_t p, double v) {
          if (p == property)
            vertices.push_back(vertexNumber(in, v, vertexCount, element.name, first.size() - 1));
        });
    return;
  }
  std::array<int, 2> ends = {firstOf(element, {"vertex1", "v1", "start", "from", "source", "a"}),
                             firstOf(element, {"vertex2", "v2", "end", "to", "target", "b"})};
  if (single(element, "v0") >= 0) ends = {single(element, "v0"), single(element, "v1")};
  for (int p : ends) in.expect(p >= 0, "edges need numbers vertex1 and vertex2");
  readElement(in, element, [&](const std::vector<double>& values) {
    std::array<std::uint32_t, 2> edge{};
    for (std::size_t k = 0; k < 2; ++k)
      edge[k] = vertexNumber(in, values[static_cast<std::size_t>(ends[k])], vertexCount, "edge",
                             mesh.edges.size());
    mesh.edges.push_back(edge);
  });
}

template <class Numbers>
Mesh readElements(Numbers in, const PlyHeader& header, std::size_t vertexCount) {
  Mesh mesh;
  for (const Element& element : header.elements) {
    if (element.name == "vertex")
      readVertices(in, element, mesh);
    else if (joinsVertices(element))
      readLines(in, element, vertexCount, mesh);
    else
      readElement(in, element, [](const std::vector<double>&) {});
  }
  return mesh;
}

// Lists of two vertices are edges, others strands; without either the vertices are a cloud.
EdgeChains chainsOf(Mesh& mesh, std::uint32_t pointsPerStrand, std::string_view name,
                    std::vector<std::string>& notes) {
  const auto& [listed, first] = mesh.lines;
  if (!listed.empty() && listed.size() == 2 * (first.size() - 1))
    for (std::size_t i = 0; i < listed.size(); i += 2)
      mesh.edges.push_back({listed[i], listed[i + 1]});
  else if (!listed.empty())
    return std::move(mesh.lines);
  if (!mesh.edges.empty()) return chainEdges(mesh.edges, mesh.positions.size(), {}, name);
  EdgeChains cloud;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) cloud.vertices.push_back(v);
  if (mesh.strandOf.empty() || pointsPerStrand > 0) {
    cloud.first = cloudStrands(mesh.positions, pointsPerStrand, name, notes);
    return cloud;
  }
  for (std::uint32_t v = 1; v < mesh.strandOf.size(); ++v)
    if (mesh.strandOf[v] != mesh.strandOf[v - 1]) cloud.first.push_back(v);
  cloud.first.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
  return cloud;
}

template <class T>
std::vector<T> picked(const std::vector<T>& items, const std::vector<std::uint32_t>& which) {
  std::vector<T> result;
  if (items.empty()) return result;
  result.reserve(which.size());
  for (std::uint32_t i : which) result.push_back(items[i]);
  return result;
}

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

}  // namespace

StrandFile parsePly(std::string_view bytes, std::string_view name, std::uint32_t pointsPerStrand) {
  TextReader in(bytes, name);
  const PlyHeader header = readPlyHeader(in, bytes.size());
  const Element* vertices = nullptr;
  bool joined = false, faces = false;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertices = &element;
    joined = joined || joinsVertices(element);
    faces = faces || (element.name == "face" && element.count > 0);
  }
  in.expect(vertices && vertices->count > 0, "the file holds no vertices");
  in.expect(joined || !faces || pointsPerStrand > 0,
            "the file holds faces and no edges: it is a mesh, not strands");
  const std::size_t count = vertices->count;
  Mesh mesh = header.binary ? readElements(BinaryNumbers(bytes, name, header), header, count)
                            : readElements(TextNumbers(in), header, count);

  StrandFile file;
  // An element of edges that is empty leaves strands of a point each.
  EdgeChains chains = joined && mesh.edges.empty() && mesh.lines.vertices.empty()
                          ? chainEdges({}, mesh.positions.size(), {}, name)
                          : chainsOf(mesh, pointsPerStrand, name, file.notes);
  file.format = "ply";
  file.scale = header.scale;
  file.up = header.up;
  file.strands = {picked(mesh.positions, chains.vertices), std::move(chains.first)};
  file.thickness = picked(mesh.thickness, chains.vertices);
  file.transparency = picked(mesh.transparency, chains.vertices);
  file.colours = picked(mesh.colours, chains.vertices);
  return file;
}

void writePly(std::ostream& out, const StrandFile& file) {
  const StrandSet& strands = file.strands;
  require(strands.pointCount() < (std::size_t{1} << 31), "writing .ply: ", strands.pointCount(),
          " points; at most 2^31 - 1");
  const bool thickness = !file.thickness.empty() || file.defaultThickness > 0;
  const bool transparency = !file.transparency.empty() || file.defaultTransparency > 0;
  const bool colours = !file.colours.empty() || file.defaultColour != glm::vec3(0);
  {
    TextWriter header(out);
    header << "ply\nformat binary_little_endian 1.0\ncomment " << unitsText(file.scale, file.up)
           << "\nelement vertex " << strands.pointCount()
           << "\nproperty float x\nproperty float y\nproperty float z\n";
    if (colours) header << "property float red\nproperty float green\nproperty float blue\n";
    if (thickness) header << "property float thickness\n";
    if (transparency) header << "property float transparency\n";
    header << "element edge " << strands.segmentCount()
           << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  }
  constexpr std::size_t kBlock = 1 << 16;
  std::string block;
  const auto flush = [&](std::size_t from) {
    if (block.size() < from) return;
    out.write(block.data(), static_cast<std::streamsize>(block.size()));
    block.clear();
  };
  for (std::size_t i = 0; i < strands.pointCount(); ++i) {
    put(block, strands.points[i]);
    if (colours) put(block, file.colours.empty() ? file.defaultColour : file.colours[i]);
    if (thickness) put(block, file.thickness.empty() ? file.defaultThickness : file.thickness[i]);
    if (transparency)
      put(block, file.transparency.empty() ? file.defaultTransparency : file.transparency[i]);
    flush(kBlock);
  }
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    for (std::uint32_t i = strands.first[s]; i + 1 < strands.first[s + 1]; ++i) {
      put(block, std::array{i, i + 1});
      flush(kBlock);
    }
  flush(0);
}

}  // namespace hair

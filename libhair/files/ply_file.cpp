#include <libhair/files/ply_file.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <libhair/files/byte_reader.h>
#include <libhair/files/edges.h>
#include <libhair/files/file_units.h>
#include <libhair/files/ply_header.h>
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
  BinaryNumbers(std::string_view bytes, std::string_view name, std::size_t begin)
      : in_(bytes, name) {
    in_.seek(begin, "elements");
  }
  void expectElements(const Element& element) const {
    in_.expectLeft(element.count, element.leastBytes(), element.name);
  }
  void beginElement() {}
  double next(Type type, std::string_view what) {
    switch (type) {
      case Type::Int8:
        return in_.read<std::int8_t>(what);
      case Type::Uint8:
        return in_.read<std::uint8_t>(what);
      case Type::Int16:
        return in_.read<std::int16_t>(what);
      case Type::Uint16:
        return in_.read<std::uint16_t>(what);
      case Type::Int32:
        return in_.read<std::int32_t>(what);
      case Type::Uint32:
        return in_.read<std::uint32_t>(what);
      case Type::Float32:
        return static_cast<double>(in_.read<float>(what));
      case Type::Float64:
        return in_.read<double>(what);
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
  ByteReader in_;
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

// Goes through the items of an element; `take` gets each one's single numbers, lists are passed.
template <class Numbers, class Take>
void readElement(Numbers& in, const Element& element, Take&& take) {
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
      for (double k = 0; k < count; ++k) in.next(property.type, property.name);
    }
    take(values);
  }
}

struct Mesh {
  std::vector<glm::vec3> positions, colours;
  std::vector<float> thickness, transparency;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

// Index of a scalar property in an element; lists of that name are ignored.
int single(const Element& element, std::string_view name) {
  const int at = element.find(name);
  return at >= 0 && !element.properties[static_cast<std::size_t>(at)].countType ? at : -1;
}

template <class Numbers>
void readVertices(Numbers& in, const Element& element, Mesh& mesh) {
  const std::array<int, 3> xyz = {single(element, "x"), single(element, "y"), single(element, "z")};
  const std::array<int, 3> rgb = {single(element, "red"), single(element, "green"),
                                  single(element, "blue")};
  const int thickness = single(element, "thickness");
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
    if (thickness >= 0) mesh.thickness.push_back(number(thickness));
    if (transparency >= 0) mesh.transparency.push_back(number(transparency));
    mesh.positions.push_back(position);
  });
}

template <class Numbers>
void readEdges(Numbers& in, const Element& element, std::size_t vertexCount, Mesh& mesh) {
  const std::array<int, 2> ends = {single(element, "vertex1"), single(element, "vertex2")};
  for (int p : ends) in.expect(p >= 0, "edges need numbers vertex1 and vertex2");
  readElement(in, element, [&](const std::vector<double>& values) {
    std::array<std::uint32_t, 2> edge{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double v = values[static_cast<std::size_t>(ends[k])];
      in.expect(v >= 0 && v < static_cast<double>(vertexCount) && v == std::floor(v), "edge ",
                mesh.edges.size(), ": vertex ", v, " does not exist (", vertexCount, " vertices)");
      edge[k] = static_cast<std::uint32_t>(v);
    }
    mesh.edges.push_back(edge);
  });
}

template <class Numbers>
Mesh readElements(Numbers in, const PlyHeader& header, std::size_t vertexCount) {
  Mesh mesh;
  for (const Element& element : header.elements) {
    if (element.name == "vertex")
      readVertices(in, element, mesh);
    else if (element.name == "edge")
      readEdges(in, element, vertexCount, mesh);
    else
      readElement(in, element, [](const std::vector<double>&) {});
  }
  return mesh;
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

StrandFile parsePly(std::string_view bytes, std::string_view name) {
  TextReader in(bytes, name);
  const PlyHeader header = readPlyHeader(in, bytes.size());
  const Element *vertices = nullptr, *edges = nullptr;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertices = &element;
    if (element.name == "edge") edges = &element;
  }
  in.expect(vertices && vertices->count > 0, "the file holds no vertices");
  in.expect(edges != nullptr, "the file holds no edges: it is a mesh or a cloud, not strands");
  const std::size_t count = vertices->count;
  const Mesh mesh = header.binary
                        ? readElements(BinaryNumbers(bytes, name, header.bytes), header, count)
                        : readElements(TextNumbers(in), header, count);

  EdgeChains chains = chainEdges(mesh.edges, mesh.positions.size(), {}, name);
  StrandFile file;
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

#include <libhair/files/ply_header.h>

#include <libhair/files/file_units.h>

namespace hair {

namespace {

using Type = PlyHeader::Type;

struct TypeName {
  std::string_view name, otherName;
  Type type;
  std::size_t bytes;
};
constexpr TypeName kTypes[] = {
    {"char", "int8", Type::Int8, 1},        {"uchar", "uint8", Type::Uint8, 1},
    {"short", "int16", Type::Int16, 2},     {"ushort", "uint16", Type::Uint16, 2},
    {"int", "int32", Type::Int32, 4},       {"uint", "uint32", Type::Uint32, 4},
    {"float", "float32", Type::Float32, 4}, {"double", "float64", Type::Float64, 8}};

Type typeOf(TextReader& in) {
  const std::string_view word = in.word();
  for (const TypeName& t : kTypes)
    if (word == t.name || word == t.otherName) return t.type;
  in.fail("'", TextReader::shown(word), "' is no type of PLY");
}

void readProperty(TextReader& in, PlyHeader& header) {
  in.expect(!header.elements.empty(), "a property before the first element");
  PlyHeader::Property property;
  const std::string_view rest = in.restOfLine();
  if (rest.starts_with("list ") || rest.starts_with("list\t")) {
    in.word();
    property.countType = typeOf(in);
    in.expect(*property.countType < Type::Float32, "the length of a list must be a whole number");
  }
  property.type = typeOf(in);
  property.name = in.word();
  in.expect(!property.name.empty(), "a property without a name");
  header.elements.back().properties.push_back(std::move(property));
}

void readElement(TextReader& in, PlyHeader& header) {
  PlyHeader::Element element;
  element.name = in.word();
  const long long count = in.toInteger(in.word(), "count of an element");
  in.expect(count >= 0 && count < (1ll << 32), "element ", TextReader::shown(element.name), ": ",
            count, " of them; 0 to 2^32 - 1");
  element.count = static_cast<std::size_t>(count);
  for (const auto& other : header.elements)
    in.expect(other.name != element.name, "a second element ", TextReader::shown(element.name));
  header.elements.push_back(std::move(element));
}

}  // namespace

std::size_t plyTypeBytes(Type type) {
  return kTypes[static_cast<std::size_t>(type)].bytes;
}

int PlyHeader::Element::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return static_cast<int>(i);
  return -1;
}

std::size_t PlyHeader::Element::leastBytes() const {
  std::size_t least = 0;
  for (const Property& p : properties) least += plyTypeBytes(p.countType.value_or(p.type));
  return least;
}

PlyHeader readPlyHeader(TextReader& in, std::size_t fileBytes) {
  PlyHeader header;
  in.expect(in.nextLine() && in.word() == "ply" && in.lineDone(),
            "'ply' expected: this is no PLY file");
  bool format = false;
  while (in.nextLine()) {
    const std::string_view word = in.word();
    if (word == "format") {
      const std::string_view kind = in.word();
      header.bigEndian = kind == "binary_big_endian";
      header.binary = header.bigEndian || kind == "binary_little_endian";
      in.expect(header.binary || kind == "ascii", "format '", TextReader::shown(kind),
                "': ascii, binary_little_endian and binary_big_endian are read");
      format = true;
    } else if (word == "comment" || word == "obj_info") {
      unitsFromText(in.restOfLine(), header.scale, header.up);
    } else if (word == "element") {
      readElement(in, header);
    } else if (word == "property") {
      readProperty(in, header);
    } else if (word == "end_header") {
      in.expect(format, "the header ends without a format");
      header.bytes = fileBytes - in.left();
      return header;
    } else {
      in.fail("'", TextReader::shown(word), "' is no word of a PLY header");
    }
  }
  in.fail("the file ends within its header (truncated)");
}

}  // namespace hair

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <libhair/files/strand_file.h>
#include <libhair/files/text_reader.h>

namespace hair {

/// Contents of a PLY header.
struct PlyHeader {
  enum class Type : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
  struct Property {
    std::string name;
    Type type = Type::Float32;
    std::optional<Type> countType;  ///< of a list: how its length is written
  };
  struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
    /// Index of a property by name; -1: none.
    int find(std::string_view property) const;
    /// Least size of an element, bytes; lists may be empty.
    std::size_t leastBytes() const;
  };

  bool binary = false;
  bool bigEndian = false;
  float scale = 1;  ///< metres a unit, of our comment
  UpAxis up = UpAxis::Y;
  std::vector<Element> elements;  ///< in the order of the file
  std::size_t bytes = 0;          ///< offset of the elements
};

std::size_t plyTypeBytes(PlyHeader::Type type);

/// Reads up to `end_header`. Throws Error (file, line, cause).
PlyHeader readPlyHeader(TextReader& in, std::size_t fileBytes);

}  // namespace hair

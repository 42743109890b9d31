#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

/// An array as NumPy saves it (numpy.org/doc/stable/reference/generated/numpy.lib.format.html).
struct NpyArray {
  std::string name;  ///< in messages: of the file, or of an array in it
  char kind = 'f';   ///< f, i, u or b
  std::size_t itemBytes = 4;
  bool bigEndian = false;
  bool columnsFirst = false;  ///< Fortran's order: the first index is the fastest
  std::vector<std::size_t> shape;
  std::string_view data;

  std::size_t size() const;  ///< product of the shape
  bool isFloat() const { return kind == 'f'; }
  /// Item i in the order of the last index fastest, as a double.
  double item(std::size_t i) const;
  /// All of them as floats, in that order. Throws Error where one is finite but no float.
  std::vector<float> floats() const;
};

/// Reads the header; `data` is a part of `bytes`, checked to be as long as the shape asks. Throws
/// Error (file, byte, cause), also for arrays of objects, texts and structures.
NpyArray parseNpy(std::string_view bytes, std::string_view name);

}  // namespace hair

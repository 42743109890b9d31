#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair {

/// Contents of a .tfx file (TressFX, binary, version 4.0), in the file's own units and axes.
struct TfxFile {
  StrandSet strands;                 ///< all of the same number of points
  std::vector<std::uint8_t> pinned;  ///< [pointCount]; 1: fixed to the head (w = 0 in the file)
  std::vector<glm::vec2> strandUv;   ///< [strandCount] or empty; texture coordinates of the root
};

/// Throws Error (file, byte, cause).
TfxFile readTfx(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
TfxFile parseTfx(std::string_view bytes, std::string_view name);

/// Writes strands of 4 to 64 points, all of the same number; fixes only roots to the head (w = 0).
/// Throws Error.
void writeTfx(std::ostream& out, StrandView strands);

}  // namespace hair

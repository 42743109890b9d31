#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair {

/// What a .tfx file holds (TressFX, binary, version 4.0), in the file's own units and axes.
struct TfxFile {
  StrandSet strands;                 ///< all of the same number of points
  std::vector<std::uint8_t> pinned;  ///< [pointCount]; 1: held by the head (w = 0 in the file)
  std::vector<glm::vec2> strandUv;   ///< [strandCount] or empty; where the strand is on the skin
};

/// Throws Error (file, byte, cause).
TfxFile readTfx(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
TfxFile parseTfx(std::string_view bytes, std::string_view name);

/// Strands of 4 to 64 points, all of the same number; the head holds each one's root (w = 0) and
/// nothing else. Throws Error.
void writeTfx(std::ostream& out, StrandView strands);

}  // namespace hair

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair {

/// Contents of a .hair file (Cem Yuksel's format, "HAIR" files), in the file's own units and axes;
/// strand_file.h converts. Optional arrays are empty where the file has none; its defaults apply
/// then.
struct HairFile {
  StrandSet strands;                ///< the file's unit and axes
  std::vector<float> thickness;     ///< [pointCount] or empty
  std::vector<float> transparency;  ///< [pointCount] or empty; 0 opaque, 1 invisible
  std::vector<glm::vec3> colours;   ///< [pointCount] or empty; linear RGB, 0 to 1
  float defaultThickness = 1;       ///< where there is no array, the file's unit
  float defaultTransparency = 0;    ///< where there is no array
  glm::vec3 defaultColour{1};       ///< where there is no array; linear RGB
  std::string info;                 ///< at most 88 bytes
};

/// Throws Error (file, byte, cause).
HairFile readHair(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
HairFile parseHair(std::string_view bytes, std::string_view name);

/// Writes the whole file or nothing. Strands of equal length take the header's default, others an
/// array of segment counts. Every strand needs 1 to 65536 points, every optional array as many
/// items as there are points. Throws Error.
void writeHair(const std::filesystem::path& file, const HairFile& hair);

/// The bytes that writeHair writes.
std::string hairBytes(const HairFile& hair);

}  // namespace hair

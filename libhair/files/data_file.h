#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include <libhair/core/strands.h>

namespace hair {

/// Reads a .data file (USC-HairSalon), in the file's own units and axes. Strands of no or one
/// point and segments of no length are common there and are kept. Throws Error (file, byte,
/// cause).
StrandSet readData(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
StrandSet parseData(std::string_view bytes, std::string_view name);

/// Points alone: strands of no and one point too. Throws Error.
void writeData(std::ostream& out, StrandView strands);

}  // namespace hair

#pragma once

#include <string>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Text that states units and axes in formats without fields for them (the info text of .hair, a
/// comment of .ply and .obj): "libhair: metres, +Y up, +Z face", or "libhair: 0.01 m a unit, ...".
std::string unitsText(float scale, UpAxis up);

/// Parses that text; returns false, and changes nothing, where it begins otherwise.
bool unitsFromText(std::string_view words, float& scale, UpAxis& up);

}  // namespace hair

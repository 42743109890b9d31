#pragma once

#include <iosfwd>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Strands out of a PLY file: vertices joined by an element `edge` with `vertex1` and `vertex2`, as
/// MeshLab and Blender know it, followed to strands (chainEdges); a vertex without edges is a
/// strand of a point. Text and little-endian binary, numbers of any type; `thickness`,
/// `transparency` and `red green blue` (bytes: 0 to 255) of vertices are read, all else is left
/// alone. In the file's units, which a comment of ours states, or else metres, +Y up. `name` stands
/// for the file in messages. Throws Error (file, line or byte, cause).
StrandFile parsePly(std::string_view bytes, std::string_view name);

/// Little-endian binary, all numbers floats. A default becomes a value of every point; strands
/// have a point at least. `scale` and `up` go into a comment. Throws Error.
void writePly(std::ostream& out, const StrandFile& file);

}  // namespace hair

#pragma once

#include <iosfwd>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Reads strands from the `l` lines of an OBJ file, and single points from its `p` lines; ignores
/// faces and all else. If all `l` lines have two corners, they are edges, as Blender writes them,
/// and are joined to strands (chainEdges). In the file's units, from libhair's comment if present,
/// else metres, +Y up; sets only `strands`, `format`, `arrays`, `scale` and `up`. `name` names the
/// file in messages. Throws Error (file, line, cause).
StrandFile parseObjStrands(std::string_view bytes, std::string_view name);

/// Writes points only, unconverted, one line a segment; `scale` and `up` go into a comment. Throws
/// Error for strands without points, and coordinates of 1e8 or more.
void writeObjStrands(std::ostream& out, const StrandFile& file);

/// What an OBJ file holds.
struct ObjContents {
  std::size_t lines = 0, faces = 0;
};
ObjContents objContents(std::string_view bytes, std::string_view name);

}  // namespace hair

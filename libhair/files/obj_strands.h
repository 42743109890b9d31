#pragma once

#include <iosfwd>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Strands out of the `l` lines of an OBJ file, and of a point each out of its `p` lines; faces and
/// all else are left alone. A file all of whose `l` lines have two corners is one of edges, as
/// Blender writes it: they are followed to strands (chainEdges). In the file's units, which a
/// comment of ours states, or else metres, +Y up; only `strands`, `format`, `arrays`, `scale` and
/// `up` are set. `name` names the file in messages. Throws Error (file, line, cause).
StrandFile parseObjStrands(std::string_view bytes, std::string_view name);

/// Points only, as they stand, a line a segment; `scale` and `up` go into a comment. Strands have a
/// point at least, coordinates are below 1e8, or Error.
void writeObjStrands(std::ostream& out, const StrandFile& file);

}  // namespace hair

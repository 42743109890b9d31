#pragma once

#include <iosfwd>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Reads strands from a PLY file, text or binary of either byte order, numbers of any type:
///
/// - vertices connected by an element `edge` with `vertex1` and `vertex2`, as in MeshLab and
/// Blender,
///   joined to strands (chainEdges); a vertex without edges is a strand of one point. Also elements
///   `line`, `polyline`, `curve` or `strand` with such pairs, or with a list of vertices each.
/// - without those a cloud: strands end where `strand_id` of the vertices changes, or have equal
///   numbers of points (cloudStrands).
///
/// Reads `thickness` (or `width`, `radius`), `transparency` and `red green blue` (bytes: 0 to 255)
/// of vertices, ignores all else. In the file's units, from libhair's comment if present, else
/// metres, +Y up. `name` names the file in messages. Throws Error (file, line or byte, cause).
StrandFile parsePly(std::string_view bytes, std::string_view name,
                    std::uint32_t pointsPerStrand = 0);

/// Writes little-endian binary, all numbers floats. Expands defaults to a value at every point;
/// strands need at least one point. `scale` and `up` go into a comment. Throws Error.
void writePly(std::ostream& out, const StrandFile& file);

}  // namespace hair

#pragma once

#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Strands in arrays of NumPy: a .npy file, or the arrays of a .npz file.
///
/// - points: floats [strands, points, 3], where points that are not finite at a strand's end are
///   padding; or [n, 3]. Of several such arrays the one called points, strands, positions ... is
///   taken.
/// - where points are [n, 3], whole numbers say which strand has them: counts [strands], offsets
///   [strands] or [strands + 1] (the first 0), ends [strands], or the strand of every point [n]. If
///   there are none, strands have equal numbers of points (cloudStrands).
/// - widths or radii, a number for every point, strand, or for all; colours [..., 3].
///
/// What was taken for what becomes a note. Metres, +Y up. Throws Error (file, byte, cause).
StrandFile parseNumpy(std::string_view bytes, std::string_view name,
                      std::uint32_t pointsPerStrand = 0);

}  // namespace hair

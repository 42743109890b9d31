#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/api.h>
#include <libhair/core/fibre.h>
#include <libhair/core/strands.h>
#include <libhair/density/density_map.h>

namespace HAIR_API hair {

/// Adds strands to a cleared map (Bertails et al. 2005, section 3.1), on all threads; the counts
/// are integers, so the result has the same bits for any number of threads.
///
/// A segment of length l at angle theta to the light, of width w and opacity alpha, adds
///
///   l · sin(theta) · w · hairsPerStrand · extinctionOf(fibre, ds) / ds²
///
/// to the optical depth of its column (Columns, Segments), or l · hairsPerStrand metres
/// (Quantity::Length, parallel light only). Deposit::Points adds one count
/// per point instead, each worth f · ds. Only every strandStride-th strand is read, and counts for
/// that many (1 to 2^30 - 1).
///
/// Adds nothing silently wrong: map.saturatedCells counts the cells whose sum did not fit, and
/// map.aliased() says whether the hair is larger than the map. May be called again to
/// add more; with Deposit::Points all of it counts as the points of the first call did.
/// `weights`: [strandCount], [0, 1], what of its width each strand has, or empty: all of it.
/// Deposit::Points, which counts whole points, takes no notice of them.
void deposit(StrandView strands, const Fibre& fibre, DensityMap& map,
             std::uint32_t strandStride = 1, std::span<const float> weights = {});

}  // namespace hair

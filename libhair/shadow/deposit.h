#pragma once

#include <cstdint>

#include <libhair/core/api.h>
#include <libhair/core/drawn_hair.h>
#include <libhair/density/deposit.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Splats the optical depth of hair into a cleared map (Bertails et al. 2005, section 3.1), by
/// deposit into its grid (density/deposit.h).
///
/// A segment of length l at angle theta to the light, of width w and opacity alpha, adds
///
///   l · sin(theta) · w · hairsPerStrand · extinctionOf(fibre, ds) / ds²
///
/// to the optical depth of its column (Columns, Segments). Deposit::Points adds one count per point
/// instead, of optical depth f · ds (DensityMapSettings::pointExtinction).
///
/// May be called again to add more. Throws Error for a map that was never cleared, and for fibres
/// and arguments out of range.
void deposit(const DrawnHair& hair, DensityMap& map, std::uint32_t strandStride = 1);

/// All strands at full width, without level of detail.
inline void deposit(StrandView strands, const Fibre& fibre, DensityMap& map,
                    std::uint32_t strandStride = 1) {
  deposit(DrawnHair{strands, fibre}, map, strandStride);
}

}  // namespace hair

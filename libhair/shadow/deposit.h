#pragma once

#include <cstdint>

#include <libhair/core/api.h>
#include <libhair/core/drawn_hair.h>
#include <libhair/density/deposit.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Adds the optical depth of hair to a cleared map (Bertails et al. 2005, section 3.1); as deposit
/// into the map's grid (density/deposit.h).
///
/// A segment of length l at angle theta to the light, of width w and opacity alpha, adds
///
///   l · sin(theta) · w · hairsPerStrand · extinctionOf(fibre, ds) / ds²
///
/// to the optical depth of its column (Columns, Segments). Deposit::Points adds one count per point
/// instead, each worth f · ds (DensityMapSettings::pointExtinction).
///
/// May be called again to add more. Throws Error for a map that was never cleared, and for fibres
/// and arguments out of range.
void deposit(const DrawnHair& hair, DensityMap& map, std::uint32_t strandStride = 1);

/// Strands of full width, at no level of detail.
inline void deposit(StrandView strands, const Fibre& fibre, DensityMap& map,
                    std::uint32_t strandStride = 1) {
  deposit(DrawnHair{strands, fibre}, map, strandStride);
}

}  // namespace hair

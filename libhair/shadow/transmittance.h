#pragma once

#include <libhair/core/api.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// From densities to transmittance (Bertails et al. 2005, section 3.2, equation 3):
///
///   Trans(i, j, k) = prod over i' from i_min to i of exp(-(optical depth of cell i', j, k))
///
/// the part of the light that leaves cell (i, j, k) through its back face; i_min is the slice of
/// the deposited hair that is nearest to the light. Threads share the columns.
void computeTransmittance(DensityMap& map);

}  // namespace hair

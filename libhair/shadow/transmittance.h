#pragma once

#include <libhair/core/api.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Computes transmittance from optical depth (Bertails et al. 2005, section 3.2, equation 3):
///
///   Trans(i, j, k) = prod over i' from i_min to i of exp(-(optical depth of cell i', j, k))
///
/// the transmittance at the back face of cell (i, j, k); i_min is the hair's slice nearest to the
/// light. Threads over columns.
void computeTransmittance(DensityMap& map);

}  // namespace hair

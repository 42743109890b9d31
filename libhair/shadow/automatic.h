#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// The longest side of the hair's box as a map under that light has it: metres (at the pivot of a
/// light at a point). 0 for no hair.
float extentSeen(StrandView strands, const LightSpace& light);

/// Settings of the density map for shadows averaged over a disc of radius `footprint` (metres, >
/// 0), as measurement chose them (docs/measurements.md). Reads the strands' extent under that
/// light.
DensityMapSettings automaticMapSettings(StrandView strands, const LightSpace& light,
                                        float footprint);

}  // namespace hair

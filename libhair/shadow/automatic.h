#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Longest side of the hair's bounding box in the axes of a map of that light, metres (at the pivot
/// of a point light). 0 for no hair.
float extentSeen(StrandView strands, const LightSpace& light);

/// Density map settings for shadows averaged over a disc of radius `footprint` (metres, > 0),
/// fitted to the strands' extent under that light. Chosen by measurement (docs/measurements.md).
DensityMapSettings automaticMapSettings(StrandView strands, const LightSpace& light,
                                        float footprint);

}  // namespace hair

#pragma once

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Interpolation between pixel centres of a light image.
enum class LateralFilter {
  Nearest,  ///< the pixel that contains the point, as the papers' single texture fetch
  Linear,   ///< transmittances of the four nearest pixels, bilinear
};

}  // namespace hair

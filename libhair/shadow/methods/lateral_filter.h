#pragma once

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// How an image of the light is read between the middles of its pixels.
enum class LateralFilter {
  Nearest,  ///< the pixel that the point falls into, as the papers' single texture fetch
  Linear,   ///< transmittances of the four nearest pixels, bilinear
};

}  // namespace hair

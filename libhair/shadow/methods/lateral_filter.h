#pragma once

#include <libhair/core/api.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// Interpolation between pixel centres of a light image.
enum class LateralFilter {
  Nearest,  ///< the pixel that contains the point, as the papers' single texture fetch
  Linear,   ///< transmittances of the four nearest pixels, bilinear
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(LateralFilter) {
  return std::array{Word("nearest", LateralFilter::Nearest), Word("linear", LateralFilter::Linear)};
}

}  // namespace hair

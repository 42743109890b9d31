#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace HAIR_API hair {

class ShadowMethod;

/// Opacity shadow maps (Kim and Neumann 2001): equidistant planes across the light slice the hair;
/// each pixel of each slice sums the opacity inside; sums are interpolated linearly between planes.
struct OpacityMapSettings {
  float pixelSize = 3e-3f;                       ///< metres, > 0
  int slices = 16;                               ///< 1 to 1024
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeOpacityMap(const OpacityMapSettings& settings);

}  // namespace hair

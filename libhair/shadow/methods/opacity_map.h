#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace HAIR_API hair {

class ShadowMethod;

/// Opacity shadow maps (Kim and Neumann 2001): equidistant planes across the light slice the hair;
/// each pixel of each slice sums the opacity inside; sums are interpolated linearly between planes.
struct OpacityMapSettings {
  float pixelSize = 3e-3f;                       ///< metres, > 0
  int slices = 16;                               ///< across the light, evenly
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const OpacityMapSettings*) {
  using S = OpacityMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("slices", &S::slices, "[1, 1024]"), Field("extinction", &S::extinction),
                    Field("filter", &S::filter));
}

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeOpacityMap(const OpacityMapSettings& settings);

}  // namespace hair

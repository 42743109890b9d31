#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace HAIR_API hair {

class ShadowMethod;

/// Shadow map (Williams 1978) with percentage-closer filtering (Reeves, Salesin and Cook 1987): the
/// depth of the first hair in each pixel; a point is lit by the share of the pixels around it whose
/// first hair is not in front of it. Hair is opaque to it.
struct ShadowMapSettings {
  float pixelSize = 1e-3f;     ///< metres, > 0
  float filterRadius = 3e-3f;  ///< metres, >= 0: of the disc of pixels compared
  float bias = 1e-3f;  ///< metres, >= 0, that a point is taken nearer to the light than it is
};

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeShadowMap(const ShadowMapSettings& settings);

}  // namespace hair

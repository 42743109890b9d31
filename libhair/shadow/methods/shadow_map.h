#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace HAIR_API hair {

class ShadowMethod;

/// Shadow map (Williams 1978) with percentage-closer filtering (Reeves, Salesin and Cook 1987): the
/// depth of the first hair in each pixel; transmittance at a point is the fraction of the pixels
/// around it whose first hair is not in front of it. Treats hair as opaque.
struct ShadowMapSettings {
  float pixelSize = 1e-3f;     ///< metres, > 0
  float filterRadius = 3e-3f;  ///< metres, >= 0: radius of the disc of compared pixels
  float bias = 1e-3f;          ///< metres, >= 0, by which points are moved towards the light
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const ShadowMapSettings*) {
  using S = ShadowMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("filterRadius", &S::filterRadius, "[0, inf) m"),
                    Field("bias", &S::bias, "[0, inf) m"));
}

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeShadowMap(const ShadowMapSettings& settings);

}  // namespace hair

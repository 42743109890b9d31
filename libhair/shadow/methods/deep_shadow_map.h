#pragma once

#include <memory>

#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace hair {

class ShadowMethod;

/// Deep shadow maps (Lokovic and Veach 2000): each pixel's whole visibility function, compressed to
/// the fewest pieces that a greedy walk finds within `tolerance` of it everywhere.
struct DeepShadowMapSettings {
  float pixelSize = 3e-3f;   ///< metres, > 0
  float tolerance = 0.01f;   ///< of transmittance, >= 0; 0: every fragment is kept
  Extinction extinction = Extinction::Unbiased;
  LateralFilter filter = LateralFilter::Linear;
};

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDeepShadowMap(const DeepShadowMapSettings& settings);

}  // namespace hair

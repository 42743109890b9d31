#pragma once

#include <memory>

#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace hair {

class ShadowMethod;

/// Density clustering (Mertens et al. 2004): each pixel's fragments are clustered by depth; a cluster
/// is a bin over which optical depth grows evenly, sqrt(3) standard deviations to both sides of its
/// mean (section 3.2).
struct DensityClusteringSettings {
  /// Where clusters begin (section 3.3).
  enum class Start {
    Uniform,      ///< evenly between a pixel's first and last fragment
    TowardsLight, ///< closer together near the light, where shadows change most
  };
  float pixelSize = 3e-3f;  ///< metres, > 0
  int clusters = 4;         ///< K, 1 to 64
  int iterations = 1;       ///< of k-means, >= 1
  Start start = Start::Uniform;
  Extinction extinction = Extinction::Unbiased;
  LateralFilter filter = LateralFilter::Linear;
};

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDensityClustering(const DensityClusteringSettings& settings);

}  // namespace hair

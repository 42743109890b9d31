#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/shadow/extinction.h>
#include <libhair/shadow/footprint.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Base of methods with an image of optical depths. For a fair comparison it removes half of a
/// strand's own shadow from its points, as the density map does (sampleStrandTransmittance); not
/// with published extinction, nor with the nearest-pixel filter.
class ImageMethod : public ShadowMethod {
 public:
  void sampleStrands(StrandView strands, std::span<float> out) const final {
    sample(strands.points, out);
    if (withoutOwn_ == 1) return;
    for (float& t : out) t = std::min(t * withoutOwn_, 1.0f);
  }

 protected:
  /// Settings: any with pixelSize, extinction and filter.
  template <class Settings>
  void setOwnShadow(const Fibre& fibre, const Settings& settings) {
    withoutOwn_ = 1;
    if (settings.extinction == Extinction::Published || settings.filter == LateralFilter::Nearest)
      return;
    DensityMapSettings pixels;
    pixels.cellSize = settings.pixelSize;
    const float line = FootprintKernel(pixels).onALine() / settings.pixelSize;
    withoutOwn_ = std::exp(0.5f * fibre.width * extinctionOf(fibre, settings.pixelSize) * line);
  }

 private:
  float withoutOwn_ = 1;
};

}  // namespace hair

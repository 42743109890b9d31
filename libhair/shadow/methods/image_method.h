#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/shadow/extinction.h>
#include <libhair/shadow/footprint.h>
#include <libhair/shadow/methods/light_image.h>
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
  /// What every build starts with: checks the fibre, sets the factor for strands' own shadows, and
  /// fits the image to the strands. Settings: any with pixelSize, extinction and filter. `method`:
  /// the name in errors.
  template <class Settings>
  LightImage startBuild(StrandView strands, const Fibre& fibre, const LightSpace& light,
                        const Settings& settings, const char* method) {
    requireFibre(fibre, method);
    setOwnShadow(fibre, settings);
    return makeLightImage(strands, light, settings.pixelSize);
  }

 private:
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

  float withoutOwn_ = 1;
};

}  // namespace hair

#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/shadow/density_map.h>

namespace hair {

/// The separable kernel of Filter::Footprint, along one axis, in cells.
///
/// The target is the mean over a disc of radius R, of variance R²/4 along each axis. A box of
/// half-width h has h²/3; splatting has blurred the hair by a box of one cell (variance 1/12), and
/// values are linear between cell centres (a tent, 1/6):
///
///   h²/3 + 1/6 + 1/12 = R²/4
///
/// The square of side 2h has nearly the disc's area, and being separable needs a row of weights
/// instead of a table.
struct FootprintKernel {
  float halfWidth;  ///< h, cells; > 0

  explicit FootprintKernel(const DensityMapSettings& settings) {
    const float radius =
        settings.filter == Filter::Footprint ? settings.footprint / settings.cellSize : 0.0f;
    halfWidth = std::sqrt(std::max(3 * (0.25f * radius * radius - 1.0f / 6 - 1.0f / 12), 1e-4f));
  }

  /// Kernel weight per cell along a line through the point, in the plane across the light, averaged
  /// over the line's directions. (1 / this: the kernel's mean width.)
  float onALine() const {
    // For a line along an axis: the full kernel at its centre, which is the mean over the box of
    // the blurred tent, a spline of order 3.
    const float h = halfWidth;
    const auto order3 = [](float t) {
      return t < 0.5f ? 0.75f * t - t * t * t / 3 : 0.5f - cube(std::max(1.5f - t, 0.0f)) / 6;
    };
    const float along = order3(h) / h;
    // Averaged over directions, a square's chord through its centre is 4/pi · ln(1 + sqrt 2) times
    // its side; a round kernel needs no such factor. Blur makes a small box round.
    const float square = h > 1 ? 1.122f : 1 + 0.122f * h;
    return along * square;
  }

 private:
  static float cube(float t) { return t * t * t; }
};

}  // namespace hair

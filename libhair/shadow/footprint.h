#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/shadow/density_map.h>

namespace hair {

/// The kernel of Filter::Footprint, an axis at a time, in cells.
///
/// Wanted is the mean over a disc of radius R, which has the variance R²/4 along each axis. A box
/// of half-width h has h²/3; the deposit has smeared the hair over a box of one cell already
/// (variance 1/12), and values are linear between cell centres (a tent, 1/6):
///
///   h²/3 + 1/6 + 1/12 = R²/4
///
/// Its square of side 2h has nearly the disc's area, and being a product it costs a row of weights
/// instead of a table.
struct FootprintKernel {
  float halfWidth;  ///< h, cells; > 0

  explicit FootprintKernel(const DensityMapSettings& settings) {
    const float radius =
        settings.filter == Filter::Footprint ? settings.footprint / settings.cellSize : 0.0f;
    halfWidth = std::sqrt(std::max(3 * (0.25f * radius * radius - 1.0f / 6 - 1.0f / 12), 1e-4f));
  }

  /// Of all that stands on a line through the point, as seen across the light, the share in an area
  /// of one cell: the mean over the line's directions. (1 / this: the kernel's width.)
  float onALine() const {
    // The whole kernel at its middle, where the line is along an axis: the mean of the smeared
    // tent, a spline of order 3, over the box.
    const float h = halfWidth;
    const auto order3 = [](float t) {
      return t < 0.5f ? 0.75f * t - t * t * t / 3 : 0.5f - cube(std::max(1.5f - t, 0.0f)) / 6;
    };
    const float along = order3(h) / h;
    // A square's chord through its middle is longer, on average over directions, than its side by
    // 4/pi · ln(1 + sqrt 2); a round kernel's is not. The smearing makes a small box round.
    const float square = h > 1 ? 1.122f : 1 + 0.122f * h;
    return along * square;
  }

 private:
  static float cube(float t) { return t * t * t; }
};

}  // namespace hair

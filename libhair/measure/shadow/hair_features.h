#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>

namespace hair {

/// The properties of hair that determine the time of its shadows, in the axes of its light: x along
/// it, y and z across. Lengths in metres; under a light at a point those of its mapping
/// (CellFrame), which are metres at the pivot.
struct HairFeatures {
  double strands = 0,  ///< number of strands
      points = 0,      ///< of all strands
      segments = 0;    ///< of all strands
  glm::dvec3 size{0};  ///< of the hair's box
  glm::dvec3 way{
      0};  ///< sum over segments of |dx|, |dy|, |dz|: walls crossed, times their distance
  double longestWay = 0;  ///< sum over segments of the largest of the three

  /// Fraction of the boxes that strands enter which none of the strands shortly before them in
  /// memory has entered, and which caches have dropped. 0: strands are next to the previous ones.
  double coldShare = 0;

  /// Number of boxes of side coarsest / 2^level that hold hair, for each level.
  struct Occupied {
    std::vector<double> count;  ///< [levels], the coarsest first
    double coarsest = 1;        ///< side of level 0
    /// Interpolates to any side, in metres, by a power law; extrapolates beyond the levels.
    double at(double side) const;
  };
  Occupied boxes;   ///< of three dimensions
  Occupied pixels;  ///< seen by the light: (y, z)

  /// Number of cells of this size that segments enter: one each, and one per wall crossed.
  double cellsCrossed(double cell) const { return segments + (way.x + way.y + way.z) / cell; }
  /// The same for pixels of this size across the light.
  double pixelsCrossed(double pixel) const { return segments + (way.y + way.z) / pixel; }
};

/// Measures hair: one pass over the points, and a walk along strands (all, or a sample of some
/// thousands) in steps of a 128th of the hair's extent.
HairFeatures hairFeatures(StrandView strands, const LightSpace& light);

}  // namespace hair

#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>

namespace HAIR_API hair {

/// What the time to shadow hair depends on, as seen from its light: x along it, y and z across.
/// Lengths in metres; under a light at a point those of its mapping (CellFrame), which are metres
/// at the pivot.
struct HairFeatures {
  double strands = 0,  ///< how many
      points = 0,      ///< of all strands
      segments = 0;    ///< of all strands
  glm::dvec3 size{0};  ///< of the hair's box
  glm::dvec3 way{
      0};  ///< sum over segments of |dx|, |dy|, |dz|: walls crossed, times their distance
  double longestWay = 0;  ///< sum over segments of the largest of the three

  /// Share of the boxes that strands enter into which none of the strands shortly before them in
  /// memory went: what caches have forgotten. 0: strands lie beside those before them.
  double coldShare = 0;

  /// How many boxes of side coarsest / 2^level hold hair, level after level.
  struct Occupied {
    std::vector<double> count;  ///< [levels], the coarsest first
    double coarsest = 1;        ///< side of level 0
    /// At any side; between levels, and beyond them, a power of the side.
    double at(double side) const;
  };
  Occupied boxes;   ///< of three dimensions
  Occupied pixels;  ///< seen by the light: (y, z)

  /// Cells of this size that segments enter: one each, and one a wall.
  double cellsCrossed(double cell) const { return segments + (way.x + way.y + way.z) / cell; }
  /// The same for pixels of this size, seen by the light.
  double pixelsCrossed(double pixel) const { return segments + (way.y + way.z) / pixel; }
};

/// One pass over the points, and a walk along strands in steps of a 128th of the hair's extent (of
/// every strand up to some thousands, of some thousands beyond).
HairFeatures hairFeatures(StrandView strands, const LightSpace& light);

}  // namespace hair

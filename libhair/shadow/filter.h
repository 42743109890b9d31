#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Transmittance at points (Bertails et al. 2005, section 3.3), with map.settings.filter. The
/// points need not be hair: a head or the ground is shadowed by the hair in the same way. Exactly 1
/// in front of all hair and beside it, out of the reach of deposit and filter (one or two cells, or
/// the footprint), and everywhere in an empty map.
/// `out`: [points.size()], in [0, 1].
void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out);

/// Transmittance at the points of the strands that were deposited, without the shadow that a strand
/// throws on itself: half of it is towards the light of each of its points, wherever it leads, and
/// takes an optical depth of width · extinction · (mean width of the filter's kernel)^-1 / 2. Not
/// for curls narrower than the filter, which cross their own light more often. `out`: [pointCount],
/// in [0, 1].
void sampleStrandTransmittance(const DensityMap& map, StrandView strands, std::span<float> out);

/// Transmittance for a caller with loops and threads of its own: looks up any part of the points,
/// where they are in the cache for something else. The map must stay as it is meanwhile.
class TransmittanceSampler {
 public:
  /// What the points are.
  enum class Of {
    Points,   ///< as sampleTransmittance
    Strands,  ///< as sampleStrandTransmittance
  };
  /// Throws Error where hair was deposited and computeTransmittance() is still to come.
  TransmittanceSampler(const DensityMap& map, Of what);

  /// From any number of threads. `out`: [points.size()]. Bits do not depend on the parts.
  void sample(std::span<const glm::vec3> points, std::span<float> out) const;

 private:
  const DensityMap& map_;
  float scale_;  // of what is read, before it is cut at 1
};

}  // namespace hair

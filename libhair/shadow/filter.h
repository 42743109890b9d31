#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Transmittance at points (Bertails et al. 2005, section 3.3), with map.settings.filter. Works for
/// any points, such as a head or the ground. Exactly 1 in front of all hair and beside it, beyond
/// the support of deposit and filter (one or two cells, or the footprint), and everywhere in an
/// empty map.
/// `out`: [points.size()], in [0, 1].
void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out);

/// Transmittance at the points of the deposited strands, without self-shadowing of a strand: on
/// average half of it is in front of each of its points, in any direction, with an optical depth of
/// width · extinction / (2 · mean width of the filter's kernel). Not for curls narrower than the
/// filter, which occlude themselves more often. `out`: [pointCount], in [0, 1].
void sampleStrandTransmittance(const DensityMap& map, StrandView strands, std::span<float> out);

/// Transmittance for callers with their own loops and threads: samples any subset of the points,
/// while they are in the cache. Do not change the map meanwhile.
class TransmittanceSampler {
 public:
  /// Kind of the points.
  enum class Of {
    Points,   ///< as sampleTransmittance
    Strands,  ///< as sampleStrandTransmittance
  };
  /// Throws Error if hair was deposited and computeTransmittance() was not called since.
  TransmittanceSampler(const DensityMap& map, Of what);

  /// Thread-safe. `out`: [points.size()]. Bits do not depend on how points are divided.
  void sample(std::span<const glm::vec3> points, std::span<float> out) const;

 private:
  const DensityMap& map_;
  float scale_;  // factor before clamping to 1
};

}  // namespace hair

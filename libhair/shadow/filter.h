#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/shadow/density_map.h>

namespace hair {

/// Transmittance at points (Bertails et al. 2005, section 3.3), with map.settings.filter. The
/// points need not be hair: a head or the ground is shadowed by the hair in the same way. Exactly 1
/// in front of all hair, beside it, and everywhere in an empty map.
/// `out`: [points.size()], in [0, 1].
void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out);

}  // namespace hair

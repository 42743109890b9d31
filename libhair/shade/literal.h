#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/shade/appearance.h>
#include <libhair/shade/kajiya_kay.h>

namespace hair {
namespace literal {

/// Direct implementation of section 3.3 of Bertails et al. 2005, with the second highlight of
/// KajiyaKaySettings: angles, point by point, in double, on one thread. Slow; read it for the
/// formula. The reference for tests of the fast pass, with which it shares only the lightness of a
/// strand (KajiyaKaySettings::lightnessOf).
/// `radiance`: [pointCount] linear RGB. Arguments are not checked.
void shade(StrandView strands, const Illumination& illumination, const KajiyaKaySettings& settings,
           std::span<glm::vec3> radiance);

}  // namespace literal
}  // namespace hair

#pragma once

#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/shade/illumination.h>
#include <libhair/shade/kajiya_kay.h>

namespace HAIR_API hair {
namespace literal {

/// Section 3.3 of Bertails et al. 2005, with the second highlight of KajiyaKaySettings, written
/// down as it stands: angles, one point after another, in double precision, on one thread. Slow;
/// kept as the formula to read and as the reference that the fast pass is tested against. Only the
/// lightness of a strand (KajiyaKaySettings::lightnessOf) is shared with it.
/// `radiance`: [pointCount] linear RGB. Arguments are not checked.
void shade(StrandView strands, const Illumination& illumination, const KajiyaKaySettings& settings,
           std::span<glm::vec3> radiance);

}  // namespace literal
}  // namespace hair

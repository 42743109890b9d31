#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/shade/illumination.h>
#include <libhair/shade/kajiya_kay.h>

namespace HAIR_API hair {

/// How hair looks: the settings of any of the models that there are. Each is a file of this folder,
/// which has `validate` and `shadeStrands` for its settings (kajiya_kay.h); a new one is named here
/// and nowhere else in the pipeline.
using Appearance = std::variant<KajiyaKaySettings>;

/// Throws Error for a setting out of its range, by name.
void validate(const Appearance& appearance);

/// Light that leaves all points towards the eye.
/// `radiance`: [pointCount] linear RGB, >= 0, without an upper end; or empty: it is not kept.
/// `colours`: [pointCount] what encodeSrgb makes of it, the same bits; or empty: no bytes are made.
/// Both at once, and bytes alone, cost less than a pass over radiance afterwards would.
/// Everything is linear in the lights: radiance under one alone and another alone add up, less what
/// ambient light makes.
/// Same bits on every instruction set, for any number of threads, and for strands alone. Throws
/// Error where arrays do not fit, and as `validate` of both arguments does.
void shade(StrandView strands, const Illumination& illumination, const Appearance& appearance,
           std::span<glm::vec3> radiance, std::span<std::uint32_t> colours = {});

/// Strands begin to end alone, on the calling thread; all arrays as above, [pointCount].
void shade(StrandView strands, std::size_t begin, std::size_t end, const Illumination& illumination,
           const Appearance& appearance, std::span<glm::vec3> radiance,
           std::span<std::uint32_t> colours = {});

}  // namespace hair

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

/// Settings of a reflectance model. Each model is a file of this folder with `validate` and
/// `shadeStrands` for its settings (kajiya_kay.h). Add a new one here; the rest of the pipeline
/// does not name models.
using Appearance = std::variant<KajiyaKaySettings>;

/// Throws Error for a setting out of its range, by name.
void validate(const Appearance& appearance);

/// Computes the radiance of all points towards the eye.
/// `radiance`: [pointCount] linear RGB, >= 0, unbounded; or empty: not stored.
/// `colours`: [pointCount] sRGB bytes, bit-identical to encodeSrgb; or empty: not computed.
/// Both at once, or bytes alone, cost less than a separate encoding pass.
/// Radiance is linear in the lights: results under single lights add up, except that each includes
/// the ambient term.
/// Same bits on every instruction set, for any number of threads, and for strands alone. Throws
/// Error where arrays do not fit, and as `validate` of both arguments does.
void shade(StrandView strands, const Illumination& illumination, const Appearance& appearance,
           std::span<glm::vec3> radiance, std::span<std::uint32_t> colours = {});

/// Only strands begin to end - 1, on the calling thread; arrays as above, [pointCount].
void shade(StrandView strands, std::size_t begin, std::size_t end, const Illumination& illumination,
           const Appearance& appearance, std::span<glm::vec3> radiance,
           std::span<std::uint32_t> colours = {});

}  // namespace hair

#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Encodes linear radiance as sRGB (IEC 61966-2-1), by SrgbTable. `shade` does the same where it is
/// given `colours`.
/// `radiance`: [pointCount] linear RGB; below 0 and NaN become 0, above 1 becomes 255.
/// `colours`: [pointCount] sRGB, bytes in memory R, G, B, A with A = 255.
/// Same bits on every instruction set and for any number of threads. Throws Error for arrays of
/// different sizes.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<std::uint32_t> colours);

/// The same, followed by fadeColours.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<const std::uint32_t> first,
                std::span<const float> weights, std::span<std::uint32_t> colours);

/// Fades out the strands that a level of detail removes: multiplies the opacity (highest byte) of
/// their colours by their weight.
/// `first`: [strandCount + 1] as in StrandView. `weights`: [strandCount] in [0, 1], as in
/// DrawnHair; empty: all are 1. `colours`: [pointCount]. Throws Error where arrays do not fit.
void fadeColours(std::span<const std::uint32_t> first, std::span<const float> weights,
                 std::span<std::uint32_t> colours);

}  // namespace hair

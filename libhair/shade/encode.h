#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Linear radiance to what displays show (IEC 61966-2-1), by SrgbTable: the second step after
/// `shade`, which does both at once where it is asked for colours.
/// `radiance`: [pointCount] linear RGB; below 0 and NaN become 0, above 1 becomes 255.
/// `colours`: [pointCount] sRGB, bytes in memory R, G, B, A with A = 255.
/// Same bits on every instruction set and for any number of threads. Throws Error where arrays do
/// not fit each other.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<std::uint32_t> colours);

/// The same, and fadeColours.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<const std::uint32_t> first,
                std::span<const float> weights, std::span<std::uint32_t> colours);

/// Makes strands on their way out of a level of detail as faint as they are narrow: multiplies the
/// opacity (highest byte) of their colours.
/// `first`: [strandCount + 1] as in StrandView. `weights`: [strandCount] in [0, 1], as in
/// DrawnHair; empty: all are 1. `colours`: [pointCount]. Throws Error where arrays do not fit.
void fadeColours(std::span<const std::uint32_t> first, std::span<const float> weights,
                 std::span<std::uint32_t> colours);

}  // namespace hair

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace hair {

/// How many points each strand has in a cloud of strands with equal numbers of points, by the jumps
/// from tips to the next roots; 0 where they do not show it.
std::size_t pointsPerStrandOf(std::span<const glm::vec3> points);

/// Offsets [strandCount + 1] of a cloud's strands: of `asked` points each, or where that is 0 as
/// pointsPerStrandOf says, which becomes a note. Throws Error that begins with `name`.
std::vector<std::uint32_t> cloudStrands(std::span<const glm::vec3> points, std::uint32_t asked,
                                        std::string_view name, std::vector<std::string>& notes);

}  // namespace hair

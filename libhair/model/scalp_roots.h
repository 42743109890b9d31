#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/model/styles.h>

namespace hair {

/// Horizontal unit vector that points away from the parting at p; (±1, 0, 0) beside its line.
glm::vec3 awayFromParting(const Parting& parting, glm::vec3 p);

/// `count` roots spread evenly over the scalp of the built-in head, whose distance field is
/// `headSdf`: a Fibonacci lattice of directions from the middle of the skull, jittered,
/// and a little denser at the crown.
std::vector<glm::vec3> scalpRoots(const MeshSdf& headSdf, std::uint32_t count, std::uint32_t seed);

/// The point of the scalp where the ray from the middle of the skull through p leaves the head.
glm::vec3 onScalp(const MeshSdf& headSdf, glm::vec3 p);
/// The same on the built-in head itself, within 1e-6 m of headField's surface.
glm::vec3 onScalp(glm::vec3 p);

/// The middle of the skull, metres, head space.
inline constexpr glm::vec3 kSkullMiddle(0, 0.1f, -0.005f);

/// Roots grouped by wisp. No wisp has roots on both sides of the parting.
struct WispCells {
  std::vector<glm::vec3> centres;   ///< [wispCount], on the scalp
  std::vector<std::uint32_t> wisp;  ///< [rootCount]
};

/// Cells of about equal size: Lloyd's iteration, then each root goes to the nearest centre.
WispCells wispCells(const MeshSdf& headSdf, std::span<const glm::vec3> roots,
                    std::uint32_t wispCount, const Parting& parting, std::uint32_t seed);

}  // namespace hair

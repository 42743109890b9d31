#pragma once

#include <libhair/model/styles.h>

namespace hair {

/// Makes a drawn strand for each root: weights from the root's position among its wisp's guides
/// (n·wisp .. n·wisp + n - 1 of groom.guidePoints; n = `guidesPerWisp`, 3 or 1), and offsets for
/// the root's exact position, clumping, curls, deviations, and avoidance of the head and the face
/// (`headSdf` null: none). Fills first, parents, weights and offsets of the groom.
void fillWisps(const StyleSettings& settings, const MeshSdf* headSdf, std::uint32_t guidesPerWisp,
               std::span<const glm::vec3> roots,      // [strandCount]
               std::span<const std::uint32_t> wisps,  // [strandCount]
               Groom& groom);

/// Strand s of a groom at rest, by the formula of Groom, one strand at a time.
void drawAtRest(const Groom& groom, std::size_t strand, std::span<glm::vec3> points);

}  // namespace hair

#pragma once

#include <libhair/core/api.h>
#include <libhair/model/styles.h>

namespace HAIR_API hair {

/// Hangs a drawn strand on each root: weights from where the root lies among its wisp's guides
/// (n·wisp .. n·wisp + n - 1 of groom.guidePoints; n = `guidesPerWisp`, 3 or 1), and offsets for
/// what weights cannot say: the root's exact place, clumping, curls, deviations, and keeping out of
/// the head and the face; null: out of nothing. Fills first, parents, weights and offsets of the
/// groom.
void fillWisps(const StyleSettings& settings, const MeshSdf* headSdf, std::uint32_t guidesPerWisp,
               std::span<const glm::vec3> roots,      // [strandCount]
               std::span<const std::uint32_t> wisps,  // [strandCount]
               Groom& groom);

/// Strand s of a groom at rest, as Groom's formula has it: the obvious way, one strand at a time.
void drawAtRest(const Groom& groom, std::size_t strand, std::span<glm::vec3> points);

}  // namespace hair

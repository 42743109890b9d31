#pragma once

#include <libhair/hair_mesh/script/workshop.h>

namespace hair {

/// Extrudes each bundle until it has `layers` layers. Throws Error for one that has more.
void growTo(Workshop& workshop, std::span<const std::uint32_t> bundles, std::uint32_t layers);

/// Path of hair from a root: fills `curve`, [layers + 1], the root first. `beside` is the centre of
/// the faces that share the vertex, which determines its side of a parting.
using CurveFromRoot =
    std::function<void(glm::vec3 root, glm::vec3 beside, std::span<glm::vec3> curve)>;

/// Grows the bundles to `layers` and moves layer k of all their vertices to point k of the curves.
void layAlong(Workshop& workshop, std::span<const std::uint32_t> bundles, std::uint32_t layers,
              const CurveFromRoot& curveOf);

}  // namespace hair

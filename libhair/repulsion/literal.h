#pragma once

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/density/density_grid.h>
#include <libhair/repulsion/repulsion.h>

namespace HAIR_API hair {
namespace literal {

/// What repel makes of one point, from the grid's own look-ups: the push of Bertails et al. 2005,
/// section 4.1 (RepulsionKind::CellCentre), or down the density's gradient. `allowed`: metres of
/// hair per m³. m/s². What repel is tested against.
glm::vec3 push(const DensityGrid& grid, const RepulsionSettings& settings, float allowed,
               glm::vec3 p);

}  // namespace literal
}  // namespace hair

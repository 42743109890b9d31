#pragma once

#include <glm/glm.hpp>

#include <libhair/density/density_grid.h>
#include <libhair/repulsion/repulsion.h>

namespace hair {
namespace literal {

/// Scalar reference for repel at one point: the push, m/s², of Bertails et al. 2005, section 4.1
/// (RepulsionKind::CellCentre), or down the density gradient. `allowed`: metres of hair per m³.
glm::vec3 push(const DensityGrid& grid, const RepulsionSettings& settings, float allowed,
               glm::vec3 p);

}  // namespace literal
}  // namespace hair

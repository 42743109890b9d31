#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/density/cell_frame.h>
#include <libhair/light/light.h>
#include <libhair/shadow/density_map.h>

namespace hair {
namespace literal {

/// Direct implementation of section 3 of Bertails et al. 2005: one thread, a dense grid of floats,
/// std::exp per cell, the paper's filter. Slow; the reference for tests and timings of the fast
/// passes. Only the mapping of points to cells (CellFrame) is shared with them, so that both round
/// a point into the same cell.
struct LiteralMap {
  int cells = 128;                   ///< NCELLS
  float cellSize = 7.5e-3f;          ///< ds, metres
  float extinction = 30;             ///< f, 1/metre
  CellFrame frame;                   ///< Psi
  int firstSlice = 0;                ///< i_min, wrapped
  std::vector<float> density;        ///< d, [cells³], (i · cells + j) · cells + k
  std::vector<float> transmittance;  ///< Trans, [cells³], the same order
};

/// Section 3.1: empties the map, then increments the density of the cell of every point.
void fillDensity(std::span<const glm::vec3> points, const LightSpace& light, LiteralMap& map);

/// Section 3.2, equation 3.
void computeTransmittance(LiteralMap& map);

/// Section 3.3: Trans^f at every point. Cells in front of i_min are 1 (unspecified in the paper;
/// the modulo would read the slice farthest from the light).
void filterTransmittance(const LiteralMap& map, std::span<const glm::vec3> points,
                         std::span<float> out);

/// Reference for sampleTransmittance: transmittance at one point by the map's filter, from the
/// counts of its grid alone: equation 3 for each cell, in double, then a weighted sum over cells.
/// computeTransmittance() need not be called. The map must not be aliased.
double transmittance(const DensityMap& map, glm::vec3 p);

}  // namespace literal
}  // namespace hair

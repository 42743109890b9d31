#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <libhair/density/density_grid.h>

namespace hair {

/// Points to cells: the mapping Psi of Bertails et al. 2005 (section 2.2) without its modulo, in
/// *unwrapped cell coordinates*: cell (i, j, k) covers [i, i+1) × [j, j+1) × [k, k+1), and the
/// numbers stay small because they count from the cell of `anchor`.
///
/// The world position of the anchor (origin + anchor) is computed once in double; its cell modulo
/// the grid is `base`, its position in that cell `fraction`. Per-point arithmetic is float, and
/// precise for points near the anchor.
///
/// A curved grid, Psi' (section 6: angular cells, radial slices): let v be the coordinates above in
/// the grid's axes with the pivot at 0, and K the curvature per cell. The focus is at
/// v = (-1/K, 0, 0); rho is the distance from it and g the magnification, both 1 at the pivot:
///
///   rho = |(1 + K v_x, K v_y, K v_z)|       g = 2 / (rho + 1 + K v_x)
///   u = ((2 v_x + K |v|²) / (1 + rho),  g v_y,  g v_z)
///
/// u_x is the distance from the focus minus that of the pivot; (u_y, u_z) is the stereographic
/// projection of the direction from the focus. It is conformal: cells are square all over the
/// sphere, so a thin fibre covers an area of its cell of length in (u_y, u_z) × g × width. In a
/// straight grid g = 1, and K = 0 *is* a straight grid. Only the ray from the focus away from the
/// pivot has no cell. With the focus inside the hair, hair behind the focus is spread wider than
/// any grid (DensityGrid::aliased).
struct CellFrame {
  glm::vec3 anchor{0};         ///< a point of the hair, or the pivot; metres
  glm::mat3 cellFromWorld{1};  ///< rotation / cell size, 1/metre
  glm::mat3 worldFromCell{1};  ///< its inverse, metres
  glm::vec3 fraction{0};       ///< the anchor's position in its cell, [0, 1); 0 for a pivot
  glm::ivec3 base{0};          ///< wrapped cell of the anchor, [0, cells)
  float curvature = 0;         ///< K, 1/cells

  /// Unwrapped cell coordinates of a point, clamped to ± 1e9 to fit an int.
  glm::vec3 cellCoordinates(glm::vec3 p) const {
    const glm::vec3 d = p - anchor;
    glm::vec3 u =
        fraction + (cellFromWorld[0] * d.x + cellFromWorld[1] * d.y + cellFromWorld[2] * d.z);
    if (curvature > 0) u = bend(u, curvature);
    return glm::min(glm::max(u, glm::vec3(-1e9f)), glm::vec3(1e9f));
  }
  /// The point at unwrapped cell coordinates.
  glm::vec3 point(glm::vec3 cell) const {
    glm::vec3 v = cell - fraction;
    if (curvature > 0) v = straighten(v, curvature);
    return anchor + worldFromCell * v;
  }
  /// g at unwrapped cell coordinates: extent across X in cells, relative to that of the same object
  /// at the pivot; 1 in a straight grid.
  float magnification(glm::vec3 u) const {
    return (1.0f + 0.25f * curvature * curvature * (u.y * u.y + u.z * u.z)) /
           std::max(1.0f + curvature * u.x, 1e-6f);
  }

  /// Psi', from v to u.
  static glm::vec3 bend(glm::vec3 v, float k) {
    const float ahead = 1.0f + k * v.x;
    const float across = k * k * (v.y * v.y + v.z * v.z);
    const float rho = std::sqrt(ahead * ahead + across);
    // Behind the focus rho + ahead cancels; across / (rho - ahead) is equal and does not.
    const float sum = ahead > 0 ? rho + ahead : across / (rho - ahead + 1e-30f);
    if (sum < 1e-12f) return {v.x, 1e9f, 1e9f};
    const float g = 2.0f / sum;
    return {(2.0f * v.x + k * (v.x * v.x + v.y * v.y + v.z * v.z)) / (1.0f + rho), g * v.y,
            g * v.z};
  }
  /// Inverse of Psi', from u to v.
  static glm::vec3 straighten(glm::vec3 u, float k) {
    const float square = u.y * u.y + u.z * u.z;
    const float part = 1.0f / (4.0f + k * k * square);
    const float rho = 1.0f + k * u.x;
    return {u.x - 2.0f * k * square * part * rho, 4.0f * part * rho * u.y, 4.0f * part * rho * u.z};
  }
};

/// Cells of `cellSize` metres, `cells` along each axis. A curved grid is anchored at its pivot.
inline CellFrame makeCellFrame(const GridSpace& space, glm::vec3 anchor, float cellSize,
                               int cells) {
  if (space.curvature > 0) {
    CellFrame frame;
    frame.anchor = space.pivot;
    frame.cellFromWorld = space.gridFromWorld * (1.0f / cellSize);
    frame.worldFromCell = glm::transpose(space.gridFromWorld) * cellSize;
    frame.curvature = space.curvature * cellSize;
    return frame;
  }
  const glm::dvec3 g =
      glm::dmat3(space.gridFromWorld) * (space.origin + glm::dvec3(anchor)) / double(cellSize);
  CellFrame frame;
  frame.anchor = anchor;
  frame.cellFromWorld = space.gridFromWorld * (1.0f / cellSize);
  frame.worldFromCell = glm::transpose(space.gridFromWorld) * cellSize;
  for (int c = 0; c < 3; ++c) {
    const double whole = std::floor(g[c]);
    frame.fraction[c] = std::min(static_cast<float>(g[c] - whole), 0x1.fffffep-1f);
    // Floor-mod in double: `whole` may exceed any integer type.
    frame.base[c] = static_cast<int>(whole - cells * std::floor(whole / cells));
    frame.base[c] = std::clamp(frame.base[c], 0, cells - 1);
  }
  return frame;
}

/// floor for |x| <= 1e9. Baseline x86-64 has no instruction for std::floor and would call a
/// function.
inline int floorToInt(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/error.h>
#include <libhair/core/transform.h>

namespace hair {

/// The local frame of a light-oriented map (Bertails et al. 2005, section 2.1): its X runs along
/// the rays of a light at infinity, Y and Z across them.
///
/// Points are floats relative to `origin` (world = origin + point), which is double: hair on a head
/// 10 km from the world's origin is shadowed as it would be at the origin.
struct LightSpace {
  glm::mat3 lightFromWorld{1};  ///< rotation; its first row is the way that light travels
  glm::dvec3 origin{0};         ///< metres

  /// The way that light travels, unit.
  glm::vec3 direction() const {
    return {lightFromWorld[0][0], lightFromWorld[1][0], lightFromWorld[2][0]};
  }
};

/// The frame of light that travels along `direction` (any length but zero).
inline LightSpace makeLightSpace(glm::vec3 direction, glm::dvec3 origin = glm::dvec3(0)) {
  const float length = glm::length(direction);
  require(std::isfinite(length) && length > 0, "light direction: (", direction.x, ", ", direction.y,
          ", ", direction.z, ") is zero or not finite; set --light");
  const glm::vec3 x = direction / length;
  const glm::vec3 y = anyNormal(x);
  return {glm::transpose(glm::mat3(x, y, glm::cross(x, y))), origin};
}

/// Points to cells: the paper's mapping Psi (section 2.2) without its modulo, in *unwrapped cell
/// coordinates*: cell (i, j, k) covers [i, i+1) × [j, j+1) × [k, k+1), i grows along the light,
/// and the numbers stay small because they count from the cell of `anchor`.
///
/// The world position of the anchor (origin + anchor) goes through double once; its cell folded
/// modulo the map is `base`, the rest `fraction`. Per point all is float, and exact where the
/// points share their leading digits with the anchor.
struct CellFrame {
  glm::vec3 anchor{0};         ///< some point of the hair, metres
  glm::mat3 cellFromWorld{1};  ///< rotation / cell size, 1/metre
  glm::mat3 worldFromCell{1};  ///< its inverse, metres
  glm::vec3 fraction{0};       ///< where in its cell the anchor lies, [0, 1)
  glm::ivec3 base{0};          ///< wrapped cell of the anchor, [0, cells)

  /// Unwrapped cell coordinates of a point. Clamped to ± 1e9, so that they always fit an int.
  glm::vec3 cellCoordinates(glm::vec3 p) const {
    const glm::vec3 d = p - anchor;
    const glm::vec3 u =
        fraction + (cellFromWorld[0] * d.x + cellFromWorld[1] * d.y + cellFromWorld[2] * d.z);
    return glm::min(glm::max(u, glm::vec3(-1e9f)), glm::vec3(1e9f));
  }
  /// The point at unwrapped cell coordinates.
  glm::vec3 point(glm::vec3 cell) const { return anchor + worldFromCell * (cell - fraction); }
};

inline CellFrame makeCellFrame(const LightSpace& light, glm::vec3 anchor, float cellSize,
                               int cells) {
  const glm::dvec3 g =
      glm::dmat3(light.lightFromWorld) * (light.origin + glm::dvec3(anchor)) / double(cellSize);
  CellFrame frame;
  frame.anchor = anchor;
  frame.cellFromWorld = light.lightFromWorld * (1.0f / cellSize);
  frame.worldFromCell = glm::transpose(light.lightFromWorld) * cellSize;
  for (int c = 0; c < 3; ++c) {
    const double whole = std::floor(g[c]);
    frame.fraction[c] = std::min(static_cast<float>(g[c] - whole), 0x1.fffffep-1f);
    // Floor-mod, in double: whole may be beyond any integer's range.
    frame.base[c] = static_cast<int>(whole - cells * std::floor(whole / cells));
    frame.base[c] = std::clamp(frame.base[c], 0, cells - 1);
  }
  return frame;
}

/// floor for |x| <= 1e9, without the library call that baseline x86-64 would make of it.
inline int floorToInt(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/transform.h>

namespace HAIR_API hair {

/// The local frame of a light-oriented map (Bertails et al. 2005, section 2.1): its X runs along
/// the rays of a light at infinity, Y and Z across them; or along the ray of a light at a point
/// that goes through `pivot` (section 6, the mapping Psi').
///
/// Points are floats relative to `origin` (world = origin + point), which is double: hair on a head
/// 10 km from the world's origin is shadowed as it would be at the origin.
struct LightSpace {
  glm::mat3 lightFromWorld{1};  ///< rotation; its first row is the way that light travels
  glm::dvec3 origin{0};         ///< metres
  glm::vec3 pivot{0};           ///< what a light at a point looks at, metres
  float curvature = 0;          ///< 1 / (distance of light and pivot), 1/metre; 0: at infinity

  /// The way that light travels, unit; of a light at a point, at the pivot.
  glm::vec3 direction() const {
    return {lightFromWorld[0][0], lightFromWorld[1][0], lightFromWorld[2][0]};
  }
  /// Whether this is the frame of a light at a point.
  bool atPoint() const { return curvature > 0; }
  /// Where a light at a point is.
  glm::vec3 position() const { return pivot - direction() / curvature; }
  /// The way that light travels at p, unit.
  glm::vec3 directionAt(glm::vec3 p) const {
    if (!atPoint()) return direction();
    // direction + curvature (p - pivot): no difference of large numbers for a light far away.
    const glm::vec3 way = direction() + curvature * (p - pivot);
    const float length = glm::length(way);
    return length > 0 ? way / length : direction();
  }
};

/// The frame of light that travels along `direction` (any length but zero).
inline LightSpace makeLightSpace(glm::vec3 direction, glm::dvec3 origin = glm::dvec3(0)) {
  const float length = glm::length(direction);
  require(std::isfinite(length) && length > 0, "light direction: (", direction.x, ", ", direction.y,
          ", ", direction.z, ") is zero or not finite");
  const glm::vec3 x = direction / length;
  const glm::vec3 y = anyNormal(x);
  return {glm::transpose(glm::mat3(x, y, glm::cross(x, y))), origin};
}

/// The frame of a light at `position` that looks at `pivot` (the hair's middle, or a point that
/// moves with it), both in metres from `origin`. Cells are as large as asked for at the pivot.
inline LightSpace makePointLightSpace(glm::vec3 position, glm::vec3 pivot,
                                      glm::dvec3 origin = glm::dvec3(0)) {
  const glm::vec3 way = pivot - position;
  const float distance = glm::length(way);
  require(std::isfinite(distance) && distance > 1e-6f && distance < 1e15f, "point light: at (",
          position.x, ", ", position.y, ", ", position.z, ") it is ", distance,
          " m from the hair's middle; move it");
  LightSpace light = makeLightSpace(way, origin);
  light.pivot = pivot;
  light.curvature = 1.0f / distance;
  return light;
}

/// Points to cells: the paper's mapping Psi (section 2.2) without its modulo, in *unwrapped cell
/// coordinates*: cell (i, j, k) covers [i, i+1) × [j, j+1) × [k, k+1), i grows along the light,
/// and the numbers stay small because they count from the cell of `anchor`.
///
/// The world position of the anchor (origin + anchor) goes through double once; its cell folded
/// modulo the map is `base`, the rest `fraction`. Per point all is float, and exact where the
/// points share their leading digits with the anchor.
///
/// A light at a point, Psi' (section 6: angular cells, radial slices): let v be the coordinates
/// above in the light's axes with the pivot at 0, and K the curvature per cell. The light is at
/// v = (-1/K, 0, 0); rho is the distance from it and g the magnification, both 1 at the pivot:
///
///   rho = |(1 + K v_x, K v_y, K v_z)|       g = 2 / (rho + 1 + K v_x)
///   u = ((2 v_x + K |v|²) / (1 + rho),  g v_y,  g v_z)
///
/// u_x is the distance from the light less that of the pivot; (u_y, u_z) is the stereographic
/// projection of the ray's direction. That is conformal: cells are squares all over the sphere, so
/// that what a thin fibre covers of its cell is its length in (u_y, u_z) times g times its width,
/// as it is, with g = 1, for parallel light; K = 0 *is* parallel light. Only the ray that leads
/// straight away from the pivot has no cell; a light inside the hair sees hair in all directions,
/// and those far behind it will be farther apart than any map is large (DensityMap::aliased).
struct CellFrame {
  glm::vec3 anchor{0};         ///< some point of the hair, or the pivot; metres
  glm::mat3 cellFromWorld{1};  ///< rotation / cell size, 1/metre
  glm::mat3 worldFromCell{1};  ///< its inverse, metres
  glm::vec3 fraction{0};       ///< where in its cell the anchor lies, [0, 1); 0 for a pivot
  glm::ivec3 base{0};          ///< wrapped cell of the anchor, [0, cells)
  float curvature = 0;         ///< K, 1/cells

  /// Unwrapped cell coordinates of a point. Clamped to ± 1e9, so that they always fit an int.
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
  /// g at unwrapped cell coordinates: how much larger than at the pivot things look to the light.
  float magnification(glm::vec3 u) const {
    return (1.0f + 0.25f * curvature * curvature * (u.y * u.y + u.z * u.z)) /
           std::max(1.0f + curvature * u.x, 1e-6f);
  }

  /// Psi' from v to u, and back.
  static glm::vec3 bend(glm::vec3 v, float k) {
    const float ahead = 1.0f + k * v.x;
    const float across = k * k * (v.y * v.y + v.z * v.z);
    const float rho = std::sqrt(ahead * ahead + across);
    // Behind the light rho + ahead cancels; across / (rho - ahead) is the same and does not.
    const float sum = ahead > 0 ? rho + ahead : across / (rho - ahead + 1e-30f);
    if (sum < 1e-12f) return {v.x, 1e9f, 1e9f};
    const float g = 2.0f / sum;
    return {(2.0f * v.x + k * (v.x * v.x + v.y * v.y + v.z * v.z)) / (1.0f + rho), g * v.y,
            g * v.z};
  }
  /// From u to v.
  static glm::vec3 straighten(glm::vec3 u, float k) {
    const float square = u.y * u.y + u.z * u.z;
    const float part = 1.0f / (4.0f + k * k * square);
    const float rho = 1.0f + k * u.x;
    return {u.x - 2.0f * k * square * part * rho, 4.0f * part * rho * u.y, 4.0f * part * rho * u.z};
  }
};

/// Cells of `cellSize` metres, `cells` an axis. Of a light at a point the anchor is its pivot.
inline CellFrame makeCellFrame(const LightSpace& light, glm::vec3 anchor, float cellSize,
                               int cells) {
  if (light.atPoint()) {
    CellFrame frame;
    frame.anchor = light.pivot;
    frame.cellFromWorld = light.lightFromWorld * (1.0f / cellSize);
    frame.worldFromCell = glm::transpose(light.lightFromWorld) * cellSize;
    frame.curvature = light.curvature * cellSize;
    return frame;
  }
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

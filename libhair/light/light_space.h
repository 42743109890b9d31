#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/transform.h>
#include <libhair/density/cell_frame.h>

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

  /// The axes of a grid along this light: X the way that it travels. A grid of a light at a point
  /// is curved, with its focus in the light.
  operator GridSpace() const {  // NOLINT(google-explicit-constructor): it is one, and more
    return {lightFromWorld, origin, pivot, curvature};
  }
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

}  // namespace hair

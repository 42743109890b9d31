#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/transform.h>
#include <libhair/density/cell_frame.h>

namespace HAIR_API hair {

/// Coordinate frame of a light-oriented map (Bertails et al. 2005, section 2.1): X runs along the
/// rays of a light at infinity, Y and Z across them. For a point light, X runs along the ray
/// through `pivot` (section 6, the mapping Psi').
///
/// Points are floats relative to `origin` (world = origin + point), which is double: hair on a head
/// 10 km from the world's origin is shadowed as it would be at the origin.
struct LightSpace {
  glm::mat3 lightFromWorld{1};  ///< rotation; its first row is the direction of travel
  glm::dvec3 origin{0};         ///< metres
  glm::vec3 pivot{0};           ///< target of a point light, metres
  float curvature = 0;          ///< 1 / (distance of light and pivot), 1/metre; 0: at infinity

  /// Axes of a grid along this light: X is the direction of travel. The grid of a point light is
  /// curved, with its focus at the light.
  operator GridSpace() const {  // NOLINT(google-explicit-constructor): it is one, and more
    return {lightFromWorld, origin, pivot, curvature};
  }
  /// Direction of travel, unit; for a point light, at the pivot.
  glm::vec3 direction() const {
    return {lightFromWorld[0][0], lightFromWorld[1][0], lightFromWorld[2][0]};
  }
  /// Whether this is the frame of a point light.
  bool atPoint() const { return curvature > 0; }
  /// Position of a point light, metres.
  glm::vec3 position() const { return pivot - direction() / curvature; }
  /// Direction of travel at p, unit.
  glm::vec3 directionAt(glm::vec3 p) const {
    if (!atPoint()) return direction();
    // direction + curvature (p - pivot) avoids cancellation for a distant light.
    const glm::vec3 way = direction() + curvature * (p - pivot);
    const float length = glm::length(way);
    return length > 0 ? way / length : direction();
  }
};

/// Frame of parallel light that travels along `direction` (any length but zero).
inline LightSpace makeLightSpace(glm::vec3 direction, glm::dvec3 origin = glm::dvec3(0)) {
  const float length = glm::length(direction);
  require(std::isfinite(length) && length > 0, "light direction: (", direction.x, ", ", direction.y,
          ", ", direction.z, ") is zero or not finite");
  const glm::vec3 x = direction / length;
  const glm::vec3 y = anyNormal(x);
  return {glm::transpose(glm::mat3(x, y, glm::cross(x, y))), origin};
}

/// Frame of a point light at `position` with target `pivot` (the hair's centre, or a point that
/// moves with it), both in metres from `origin`. Cells have their nominal size at the pivot.
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

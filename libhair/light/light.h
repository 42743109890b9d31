#pragma once

#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/fields.h>
#include <libhair/core/transform.h>
#include <libhair/density/density_grid.h>

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

/// A light, for shadows and shading.
struct Light {
  /// Kind of light.
  enum class Kind : std::uint8_t {
    Parallel,  ///< at infinity, as the sun
    Point,     ///< at a point, as a lamp; inverse-square falloff
  };

  Kind kind = Kind::Parallel;     ///< selects which of the fields below are used
  glm::vec3 direction{0, -1, 0};  ///< Parallel: direction of travel, any length but zero
  glm::vec3 position{0, 3, 0};    ///< Point: metres
  /// Linear, >= 0. Point: irradiance at the *pivot* (lightSpaceOf), whatever the distance; nearer
  /// hair gets more.
  glm::vec3 colour{1};

  /// A light at infinity.
  static Light parallel(glm::vec3 direction, glm::vec3 colour = glm::vec3(1)) {
    return {Kind::Parallel, direction, glm::vec3(0), colour};
  }
  /// A light at a point, metres.
  static Light point(glm::vec3 position, glm::vec3 colour = glm::vec3(1)) {
    return {Kind::Point, glm::vec3(0, -1, 0), position, colour};
  }

  /// Equal, field by field.
  bool operator==(const Light&) const = default;
};

/// Words for them (core/fields.h).
constexpr auto wordsOf(Light::Kind) {
  return std::array{Word("parallel", Light::Kind::Parallel), Word("point", Light::Kind::Point)};
}

/// Throws Error for a colour that is negative, a direction without length, and numbers that are not
/// finite.
inline void validate(const Light& light) {
  require(glm::dot(light.colour, light.colour) < 1e30f &&
              glm::all(glm::greaterThanEqual(light.colour, glm::vec3(0))),
          "light colour: (", light.colour.x, ", ", light.colour.y, ", ", light.colour.z,
          ") is negative, too bright or no number");
  if (light.kind == Light::Kind::Parallel) return void(makeLightSpace(light.direction));
  require(glm::dot(light.position, light.position) < 1e30f, "point light: at (", light.position.x,
          ", ", light.position.y, ", ", light.position.z, ") it is not finite, or beyond 1e15 m");
}

/// Coordinate frame of the light's map. `pivot` (metres): target of a point light, where a map's
/// cells have their nominal size and the light has its nominal colour; unused for parallel light.
/// Throws Error for a direction without length, a light at its pivot, and numbers that are not
/// finite.
inline LightSpace lightSpaceOf(const Light& light, glm::vec3 pivot) {
  validate(light);
  return light.kind == Light::Kind::Parallel ? makeLightSpace(light.direction)
                                             : makePointLightSpace(light.position, pivot);
}

}  // namespace hair

#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/fields.h>
#include <libhair/light/light_space.h>

namespace HAIR_API hair {

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

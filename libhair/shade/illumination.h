#pragma once

#include <cstddef>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/light/light.h>

namespace HAIR_API hair {

/// What lights the hair, and where it is seen from: the same for every appearance. Refers to the
/// caller's arrays.
struct Illumination {
  std::span<const Light> lights;  ///< empty: ambient light only
  glm::vec3 pivot{0};             ///< where the colours of lights at points are given (Light)
  glm::vec3 eye{0, 0, 1};         ///< where the picture is taken from, metres
  /// [lights · pointCount] T of the first light's points, then of the second's; or empty: no
  /// shadows, T = 1.
  std::span<const float> transmittance;
  /// [lights · pointCount] V, what opaque things (head, body) leave of each light; or empty: all.
  std::span<const float> visibility;
};

/// Throws Error where an array does not fit lights and points, the eye is not finite, and as
/// lightSpaceOf does.
void validate(const Illumination& illumination, std::size_t pointCount);

}  // namespace hair

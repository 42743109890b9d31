#pragma once

#include <cstddef>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/light/light.h>

namespace HAIR_API hair {

/// Lights, shadows and camera: input of every reflectance model. Refers to the caller's arrays.
struct Illumination {
  std::span<const Light> lights;  ///< empty: ambient light only
  glm::vec3 pivot{0};      ///< reference point of the colours of point lights (Light), metres
  glm::vec3 eye{0, 0, 1};  ///< camera position, metres
  /// [lights · pointCount] transmittance T, [0, 1], light by light; or empty: T = 1.
  std::span<const float> transmittance;
  /// [lights · pointCount] visibility V, [0, 1], past opaque objects (head, body); or empty: V = 1.
  std::span<const float> visibility;
};

/// Throws Error for arrays that do not match lights and points, for an eye that is not finite, and
/// as lightSpaceOf does.
void validate(const Illumination& illumination, std::size_t pointCount);

}  // namespace hair

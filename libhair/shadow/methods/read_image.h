#pragma once

#include <glm/glm.hpp>

#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Transmittance at cell coordinates u of the image's frame; read(pixel, depth) returns that of one
/// pixel. Exactly 1 beside the image and up to the depth of the first hair.
template <class Read>
float readImage(const LightImage& image, LateralFilter filter, glm::vec3 u, Read&& read) {
  if (!(u.x > image.nearest)) return 1.0f;
  const auto pixel = [&](int y, int z) {
    return image.inside(y, z) ? read(image.index(y, z), u.x) : 1.0f;
  };
  if (filter == LateralFilter::Nearest) return pixel(floorToInt(u.y), floorToInt(u.z));
  // A pixel's value is located at its centre.
  const float fromY = u.y - 0.5f, fromZ = u.z - 0.5f;
  const int y = floorToInt(fromY), z = floorToInt(fromZ);
  const float partY = fromY - static_cast<float>(y), partZ = fromZ - static_cast<float>(z);
  const float near = (1.0f - partY) * pixel(y, z) + partY * pixel(y + 1, z);
  const float far = (1.0f - partY) * pixel(y, z + 1) + partY * pixel(y + 1, z + 1);
  // Four ones make exactly one: 1 - part is off by 2^-25 at most, which the sum rounds away.
  return (1.0f - partZ) * near + partZ * far;
}

}  // namespace hair

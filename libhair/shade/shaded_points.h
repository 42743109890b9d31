#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Where the models of this folder write; encode-inl.h has how. Null: is not made.
struct ShadedPoints {
  glm::vec3* radiance;     ///< [pointCount] linear RGB
  std::uint32_t* colours;  ///< [pointCount] sRGB bytes of the same, opaque
};

}  // namespace hair

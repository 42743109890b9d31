#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Output arrays of the models, written by PointWriter (encode-inl.h). Null: not written.
struct ShadedPoints {
  glm::vec3* radiance;     ///< [pointCount] linear RGB
  std::uint32_t* colours;  ///< [pointCount] sRGB bytes of the same, opaque
};

}  // namespace hair

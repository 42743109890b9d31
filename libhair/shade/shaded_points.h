#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/shade/appearance.h>

namespace hair {

/// Output arrays of the models, written by PointWriter (encode-inl.h). Null: not written.
struct ShadedPoints {
  glm::vec3* radiance;     ///< [pointCount] linear RGB
  std::uint32_t* colours;  ///< [pointCount] sRGB bytes of the same, opaque
};

/// Strands begin to end - 1, on the calling thread, without checks; called by `shade`.
void shadeStrands(StrandView strands, std::size_t begin, std::size_t end,
                  const Illumination& illumination, const KajiyaKaySettings& settings,
                  ShadedPoints out);

}  // namespace hair

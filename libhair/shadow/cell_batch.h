#pragma once

#include <cstddef>
#include <span>

#include <glm/glm.hpp>

#include <libhair/shadow/light_space.h>

namespace hair {

/// The cell coordinates of up to 64 points, one array a component: straight loops that vectorise,
/// with the same bits as CellFrame::cellCoordinates point by point.
struct CellBatch {
  static constexpr std::size_t kSize = 64;

  float x[kSize], y[kSize], z[kSize];  ///< unwrapped cell coordinates
  int i[kSize], j[kSize], k[kSize];    ///< their floors

  /// points.size() <= kSize; `shift` is subtracted from the coordinates.
  void fill(const CellFrame& frame, std::span<const glm::vec3> points, glm::vec3 shift) {
    const glm::vec3* p = points.data();
    const std::size_t count = points.size();
    const glm::mat3 m = frame.cellFromWorld;
    const glm::vec3 anchor = frame.anchor, fraction = frame.fraction;
    for (std::size_t l = 0; l < count; ++l) {
      const float dx = p[l].x - anchor.x, dy = p[l].y - anchor.y, dz = p[l].z - anchor.z;
      x[l] = clamp(fraction.x + (m[0].x * dx + m[1].x * dy + m[2].x * dz)) - shift.x;
      y[l] = clamp(fraction.y + (m[0].y * dx + m[1].y * dy + m[2].y * dz)) - shift.y;
      z[l] = clamp(fraction.z + (m[0].z * dx + m[1].z * dy + m[2].z * dz)) - shift.z;
      i[l] = floorToInt(x[l]);
      j[l] = floorToInt(y[l]);
      k[l] = floorToInt(z[l]);
    }
  }

 private:
  static float clamp(float u) {
    const float low = u > -1e9f ? u : -1e9f;
    return low < 1e9f ? low : 1e9f;
  }
};

}  // namespace hair

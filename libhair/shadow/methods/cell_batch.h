#pragma once

#include <cstddef>
#include <span>

#include <glm/glm.hpp>

#include <libhair/density/cell_frame.h>

namespace hair {

/// Cell coordinates of up to 64 points as structure of arrays, in loops that vectorise.
/// Bit-identical to CellFrame::cellCoordinates.
struct CellBatch {
  static constexpr std::size_t kSize = 64;  ///< maximum number of points

  float x[kSize],  ///< unwrapped cell coordinates, along the light
      y[kSize],    ///< across it
      z[kSize];    ///< across it
  int i[kSize],    ///< floor of x
      j[kSize],    ///< floor of y
      k[kSize];    ///< floor of z

  /// points.size() <= kSize; `shift` is subtracted from the coordinates.
  void fill(const CellFrame& frame, std::span<const glm::vec3> points, glm::vec3 shift) {
    const glm::vec3* p = points.data();
    const std::size_t count = points.size();
    const glm::mat3 m = frame.cellFromWorld;
    const glm::vec3 anchor = frame.anchor, fraction = frame.fraction;
    // Deinterleave the components first, so that the next loop vectorises.
    float dx[kSize], dy[kSize], dz[kSize];
    for (std::size_t l = 0; l < count; ++l) {
      dx[l] = p[l].x - anchor.x;
      dy[l] = p[l].y - anchor.y;
      dz[l] = p[l].z - anchor.z;
    }
    for (std::size_t l = 0; l < count; ++l) {
      const float ux = fraction.x + (m[0].x * dx[l] + m[1].x * dy[l] + m[2].x * dz[l]);
      const float uy = fraction.y + (m[0].y * dx[l] + m[1].y * dy[l] + m[2].y * dz[l]);
      const float uz = fraction.z + (m[0].z * dx[l] + m[1].z * dy[l] + m[2].z * dz[l]);
      x[l] = ux, y[l] = uy, z[l] = uz;
    }
    if (frame.curvature > 0) bend(frame.curvature, count);
    for (std::size_t l = 0; l < count; ++l) {
      x[l] = clamp(x[l]) - shift.x;
      y[l] = clamp(y[l]) - shift.y;
      z[l] = clamp(z[l]) - shift.z;
    }
    floorAll(x, i, count);
    floorAll(y, j, count);
    floorAll(z, k, count);
  }

 private:
  void bend(float curvature, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) {
      const glm::vec3 u = CellFrame::bend({x[l], y[l], z[l]}, curvature);
      x[l] = u.x, y[l] = u.y, z[l] = u.z;
    }
  }
  static void floorAll(const float* u, int* whole, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) whole[l] = floorToInt(u[l]);
  }
  static float clamp(float u) {
    const float low = u > -1e9f ? u : -1e9f;
    return low < 1e9f ? low : 1e9f;
  }
};

}  // namespace hair

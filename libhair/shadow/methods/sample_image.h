#pragma once

#include <algorithm>
#include <span>

#include <libhair/core/approximate.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/methods/cell_batch.h>
#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Transmittance at points from the pixels of an image: opticalDepth(pixel, depth) returns the
/// optical depth in front of a depth. LateralFilter::Linear interpolates the transmittances of the
/// four nearest pixel centres. Exactly 1 outside of the image. On all threads.
template <class OpticalDepth>
void sampleImage(const LightImage& image, LateralFilter filter, std::span<const glm::vec3> points,
                 std::span<float> out, OpticalDepth&& opticalDepth) {
  require(out.size() == points.size(), "shadow: ", points.size(), " points but room for ",
          out.size(), " values");
  const bool linear = filter == LateralFilter::Linear;
  const glm::vec3 shift = linear ? glm::vec3(0, 0.5f, 0.5f) : glm::vec3(0);
  const auto row = static_cast<std::size_t>(image.size.x);
  constexpr std::size_t kSize = CellBatch::kSize;
  parallelFor(points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    CellBatch c;
    float t[4][kSize] = {};
    for (std::size_t p = begin; p < end; p += kSize) {
      const std::size_t count = std::min(end - p, kSize);
      c.fill(image.frame, points.subspan(p, count), shift);
      // The image has an empty margin: points not between four of its pixels are beside all hair.
      for (std::size_t l = 0; l < count; ++l) {
        const int j = c.j[l], k = c.k[l];
        const int next = linear ? 1 : 0;
        if (image.inside(j, k) && image.inside(j + next, k + next)) {
          const std::size_t pixel = image.index(j, k);
          t[0][l] = opticalDepth(pixel, c.x[l]);
          if (!linear) continue;
          t[1][l] = opticalDepth(pixel + 1, c.x[l]);
          t[2][l] = opticalDepth(pixel + row, c.x[l]);
          t[3][l] = opticalDepth(pixel + row + 1, c.x[l]);
        } else {
          for (auto& pixelDepth : t) pixelDepth[l] = 0;
        }
      }
      // Whole arrays, no branch: these loops vectorise.
      for (std::size_t q = 0; q < (linear ? 4u : 1u); ++q)
        for (std::size_t l = 0; l < kSize; ++l) t[q][l] = expMinusApproximate(t[q][l]);
      if (linear) {
        for (std::size_t l = 0; l < count; ++l) {
          const float y = c.y[l] - static_cast<float>(c.j[l]);
          const float z = c.z[l] - static_cast<float>(c.k[l]);
          const float near = t[0][l] + y * (t[1][l] - t[0][l]);
          const float far = t[2][l] + y * (t[3][l] - t[2][l]);
          out[p + l] = near + z * (far - near);
        }
      } else {
        std::copy_n(t[0], count, out.data() + p);
      }
    }
  });
}

}  // namespace hair

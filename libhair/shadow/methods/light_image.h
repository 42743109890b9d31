#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/density/cell_walk.h>
#include <libhair/light/light.h>
#include <libhair/shadow/extinction.h>
#include <libhair/shadow/methods/cell_batch.h>

namespace hair {

/// Image plane of a camera at the light, shared by all image methods. Pixels are the cells of a
/// CellFrame projected along the light; depths are along the light, in pixels.
struct LightImage {
  CellFrame frame;      ///< from points to pixels and depths
  glm::ivec2 lower{0};  ///< unwrapped cell (y, z) of pixel (0, 0)
  glm::ivec2 size{0};   ///< pixels; the hair's bounds and a margin of one pixel
  float nearest = 0;    ///< least depth of hair
  float farthest = 0;   ///< greatest depth of hair
  float pixelSize = 0;  ///< metres (at the pivot of a point light)

  /// Pixels of the whole image.
  std::size_t pixelCount() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  }
  /// Pixel (y, z), row by row; only where inside().
  std::size_t index(int y, int z) const {
    return static_cast<std::size_t>(z - lower.y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(y - lower.x);
  }
  /// Whether the image has pixel (y, z).
  bool inside(int y, int z) const {
    return y >= lower.x && z >= lower.y && y < lower.x + size.x && z < lower.y + size.y;
  }
};

/// Throws Error for a pixel size that is not positive, and where the image would have more than
/// 8192 pixels along an axis (use larger pixels; a light inside the hair has no bounded image).
/// No hair: an image of no pixels.
LightImage makeLightImage(StrandView strands, const LightSpace& light, float pixelSize);

/// Throws Error for a fibre whose width, opacity or hairs a strand is negative or not finite;
/// `method` begins the message.
void requireFibre(const Fibre& fibre, const char* method);

/// A piece of a segment inside one pixel.
struct Fragment {
  std::size_t pixel;   ///< LightImage::index
  float depth;         ///< of its middle, in pixels
  float opticalDepth;  ///< mean over the pixel: l sin(theta) w alpha / pixel area
};

/// Calls visit(Fragment) for all fragments of one strand, root to tip. Projects each point once, in
/// batches of 64.
template <class Visit>
void forFragments(std::span<const glm::vec3> points, const Fibre& fibre, Extinction extinction,
                  const LightImage& image, Visit&& visit) {
  const float perPixel = fibre.width * fibre.hairsPerStrand *
                         extinctionOf(fibre, image.pixelSize, extinction) / image.pixelSize;
  glm::vec3 a(0);
  glm::ivec2 cell(0);
  const auto segmentTo = [&](glm::vec3 b, glm::ivec2 last) {
    const glm::vec3 d = b - a;
    float whole = perPixel * std::sqrt(d.y * d.y + d.z * d.z);
    if (image.frame.curvature > 0) whole *= image.frame.magnification(0.5f * (a + b));
    AxisWalk y(a.y, b.y, cell.x, last.x), z(a.z, b.z, cell.y, last.y);
    const auto emit = [&](float from, float to) {
      visit(Fragment{image.index(cell.x, cell.y), a.x + d.x * 0.5f * (from + to),
                     whole * (to - from)});
    };
    float behind = 0;
    for (int walls = y.left + z.left; walls > 0; --walls) {
      const float wall = std::clamp(std::min(y.next, z.next), behind, 1.0f);
      emit(behind, wall);
      behind = wall;
      const bool alongY = y.next <= z.next;
      y.cross(alongY, cell.x);
      z.cross(!alongY, cell.y);
    }
    emit(behind, 1.0f);
  };
  CellBatch batch;
  for (std::size_t begin = 0; begin < points.size(); begin += CellBatch::kSize) {
    const std::size_t count = std::min(points.size() - begin, CellBatch::kSize);
    batch.fill(image.frame, points.subspan(begin, count), glm::vec3(0));
    for (std::size_t l = 0; l < count; ++l) {
      const glm::vec3 b(batch.x[l], batch.y[l], batch.z[l]);
      const glm::ivec2 last(batch.j[l], batch.k[l]);
      if (begin + l > 0) segmentTo(b, last);
      a = b;
      cell = last;
    }
  }
}

}  // namespace hair

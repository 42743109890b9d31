#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/shadow/cell_walk.h>
#include <libhair/shadow/extinction.h>
#include <libhair/shadow/light_space.h>

namespace hair {

/// The picture that a camera at the light takes of the hair: what all the methods that look from
/// the light share. Pixels are the cells of a CellFrame seen along the light; depths run along the
/// light in units of a pixel.
struct LightImage {
  CellFrame frame;
  glm::ivec2 lower{0};  ///< unwrapped cell (y, z) of pixel (0, 0)
  glm::ivec2 size{0};   ///< pixels; the hair's bounds and a margin of one pixel
  float nearest = 0;    ///< depth of the first hair
  float farthest = 0;   ///< and of the last
  float pixelSize = 0;  ///< metres (at the pivot of a light at a point)

  std::size_t pixelCount() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  }
  /// Pixel (y, z), row by row; only where inside().
  std::size_t index(int y, int z) const {
    return static_cast<std::size_t>(z - lower.y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(y - lower.x);
  }
  bool inside(int y, int z) const {
    return y >= lower.x && z >= lower.y && y < lower.x + size.x && z < lower.y + size.y;
  }
};

/// Throws Error for a pixel size that is not positive, and where the image would have more than
/// 8192 pixels along an axis (take larger pixels; a light inside the hair sees no bounded image).
/// No hair: an image of no pixels.
LightImage makeLightImage(StrandView strands, const LightSpace& light, float pixelSize);

/// A piece of a segment inside one pixel.
struct Fragment {
  std::size_t pixel;   ///< LightImage::index
  float depth;         ///< of its middle, in pixels
  float opticalDepth;  ///< mean over the pixel: l sin(theta) w alpha / pixel area
};

/// Calls visit(Fragment) for all that the pixels see of one strand, root to tip.
template <class Visit>
void forFragments(std::span<const glm::vec3> points, const Fibre& fibre, Extinction extinction,
                  const LightImage& image, Visit&& visit) {
  const float perPixel = fibre.width * fibre.hairsPerStrand *
                         extinctionOf(fibre, image.pixelSize, extinction) / image.pixelSize;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const glm::vec3 a = image.frame.cellCoordinates(points[k - 1]);
    const glm::vec3 b = image.frame.cellCoordinates(points[k]);
    const glm::vec3 d = b - a;
    const float whole =
        perPixel * std::sqrt(d.y * d.y + d.z * d.z) * image.frame.magnification(0.5f * (a + b));
    glm::ivec3 cell = floorToCell(a);
    const glm::ivec3 last = floorToCell(b);
    AxisWalk y(a.y, b.y, cell.y, last.y), z(a.z, b.z, cell.z, last.z);
    const auto emit = [&](float from, float to) {
      visit(Fragment{image.index(cell.y, cell.z), a.x + d.x * 0.5f * (from + to),
                     whole * (to - from)});
    };
    float behind = 0;
    for (int walls = y.left + z.left; walls > 0; --walls) {
      const float wall = std::clamp(std::min(y.next, z.next), behind, 1.0f);
      emit(behind, wall);
      behind = wall;
      const bool alongY = y.next <= z.next;
      y.cross(alongY, cell.y);
      z.cross(!alongY, cell.z);
    }
    emit(behind, 1.0f);
  }
}

}  // namespace hair

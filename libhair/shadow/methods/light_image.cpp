#include <libhair/shadow/methods/light_image.h>

#include <mutex>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/density/cell_frame.h>

namespace hair {

namespace {

/// Bounds in the frame's cells. Minimum and maximum do not depend on the order of threads.
Bounds cellBounds(std::span<const glm::vec3> points, const CellFrame& frame) {
  Bounds all;
  std::mutex mutex;
  parallelFor(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    Bounds box;
    CellBatch batch;
    for (std::size_t p = begin; p < end; p += CellBatch::kSize) {
      const std::size_t count = std::min(end - p, CellBatch::kSize);
      batch.fill(frame, points.subspan(p, count), glm::vec3(0));
      for (std::size_t l = 0; l < count; ++l)
        box.extend(glm::vec3(batch.x[l], batch.y[l], batch.z[l]));
    }
    const std::lock_guard lock(mutex);
    all.extend(box.lower);
    all.extend(box.upper);
  });
  return all;
}

}  // namespace

LightImage makeLightImage(StrandView strands, const LightSpace& light, float pixelSize) {
  require(pixelSize > 0 && std::isfinite(pixelSize), "light image: pixel size ", pixelSize,
          " m is not positive");
  LightImage image;
  image.pixelSize = pixelSize;
  if (strands.pointCount() == 0) return image;
  // The number of cells only matters for the modulo, which images do not use.
  image.frame = makeCellFrame(light, strands.points.front(), pixelSize, 1 << 20);
  const Bounds box = cellBounds(strands.points, image.frame);
  const glm::vec3 size = box.size();
  constexpr float kMost = 8190;
  require(size.y < kMost && size.z < kMost, "light image: ", std::ceil(size.y), " x ",
          std::ceil(size.z), " pixels of ", pixelSize,
          " m are more than 8190; take larger pixels, or move the light out of the hair");
  const glm::ivec3 lower = floorToCell(box.lower), upper = floorToCell(box.upper);
  image.lower = glm::ivec2(lower.y, lower.z) - 1;
  image.size = glm::ivec2(upper.y, upper.z) - image.lower + 2;
  image.nearest = box.lower.x;
  image.farthest = box.upper.x;
  return image;
}

void requireFibre(const Fibre& fibre, const char* method) {
  require(fibre.width >= 0 && fibre.opacity >= 0 && fibre.opacity <= 1 &&
              fibre.hairsPerStrand >= 0 && std::isfinite(fibre.width * fibre.hairsPerStrand),
          method, ": fibre width ", fibre.width, " m, opacity ", fibre.opacity, " or ",
          fibre.hairsPerStrand, " hairs a strand is out of range");
}

}  // namespace hair

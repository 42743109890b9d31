#include <libhair/shadow/methods/light_image.h>

#include <libhair/core/error.h>

namespace hair {

LightImage makeLightImage(StrandView strands, const LightSpace& light, float pixelSize) {
  require(pixelSize > 0 && std::isfinite(pixelSize), "light image: pixel size ", pixelSize,
          " m is not positive");
  LightImage image;
  image.pixelSize = pixelSize;
  if (strands.pointCount() == 0) return image;
  // The number of cells only matters to the modulo, which images do not have.
  image.frame = makeCellFrame(light, strands.points.front(), pixelSize, 1 << 20);
  Bounds box;
  for (const glm::vec3 p : strands.points) box.extend(image.frame.cellCoordinates(p));
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

}  // namespace hair

#include <libhair/shadow/density_map.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/cell_frame.h>

namespace hair {

namespace {
constexpr int kMostCells = 1024;
}

float extentSeen(StrandView strands, const LightSpace& light) {
  if (strands.pointCount() == 0) return 0;
  const CellFrame frame = makeCellFrame(light, glm::vec3(0), 1.0f, 2);
  Bounds box;
  for (const glm::vec3 p : strands.points) box.extend(frame.cellCoordinates(p));
  const glm::vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

DensityMapSettings automaticMapSettings(StrandView strands, const LightSpace& light,
                                        float footprint) {
  require(footprint > 0 && std::isfinite(footprint), "shadow footprint: ", footprint,
          " m is not positive");
  const float extent = std::max(extentSeen(strands, light), footprint);
  DensityMapSettings settings;
  settings.filter = Filter::Footprint;
  settings.footprint = footprint;
  // The filter reads beyond the hair's bounds, and must not wrap around to their other side.
  constexpr float kMargin = 6;
  // Two cells a footprint are accurate enough; up to three are more accurate, and cheap where the
  // footprint is large.
  const float cell = std::clamp(1.5e-3f, footprint / 3, footprint / 2);
  settings.cellSize = std::max(cell, extent / (kMostCells - kMargin));
  settings.cells =
      std::clamp(static_cast<int>(std::ceil(extent / settings.cellSize + kMargin)), 16, kMostCells);
  return settings;
}

}  // namespace hair

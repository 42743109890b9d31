#include <libhair/shadow/automatic.h>

#include <algorithm>

#include <libhair/core/error.h>

namespace hair {

DensityMapSettings automaticMapSettings(StrandView strands, const LightSpace& light,
                                        float footprint) {
  require(footprint > 0, "shadow footprint: ", footprint, " m is not positive; set --footprint");
  const CellFrame frame = makeCellFrame(light, glm::vec3(0), 1.0f, 2);
  Bounds box;
  for (const glm::vec3 p : strands.points) box.extend(frame.cellCoordinates(p));
  const glm::vec3 size = box.size();
  DensityMapSettings settings = settingsForFootprint(
      footprint, strands.pointCount() > 0 ? std::max({size.x, size.y, size.z, 1e-3f}) : 1, 512);
  settings.deposit = Deposit::Trilinear;
  return settings;
}

}  // namespace hair

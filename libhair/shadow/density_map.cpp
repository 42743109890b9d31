#include <libhair/shadow/density_map.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/shadow/transmittances.h>

namespace hair {

void validate(const DensityMapSettings& s) {
  validateFields(s, "density map");
  require(s.filter != Filter::Footprint || s.footprint <= 10 * s.cellSize,
          "density map: footprint ", s.footprint, " m is more than 10 cells of ", s.cellSize,
          " m; take larger cells");
}

DensityMapSettings settingsForFootprint(float footprint, float extentNeeded, int mostCells) {
  require(footprint > 0 && extentNeeded > 0 && std::isfinite(footprint + extentNeeded),
          "density map: footprint ", footprint, " m and extent ", extentNeeded,
          " m must be positive");
  require(mostCells >= 16 && mostCells <= 1024, "density map: at most ", mostCells,
          " cells is not in 16 to 1024");
  DensityMapSettings settings;
  settings.cellSize = std::max(footprint, extentNeeded / static_cast<float>(mostCells));
  const float cells = std::ceil(extentNeeded / settings.cellSize / 16.0f * 0.999999f) * 16.0f;
  settings.cells = std::clamp(static_cast<int>(cells), 16, mostCells);
  return settings;
}

DensityMap::DensityMap() : bricks(std::make_unique<LitBricks>()) {}
DensityMap::~DensityMap() = default;
DensityMap::DensityMap(DensityMap&&) noexcept = default;
DensityMap& DensityMap::operator=(DensityMap&&) noexcept = default;

std::size_t DensityMap::bytes() const {
  return grid.bytes() +
         (grid.brickCount() + 1) * Transmittances::kLayers * Transmittances::kLayer *
             sizeof(float) +
         bricks->lightIn.size() * sizeof(bricks->lightIn[0]);
}

void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light) {
  validate(settings);
  clear(map.grid, settings, light);
  map.settings = settings;
  map.light = light;
  map.fibreShadow = 0;
  map.lit = false;
}

}  // namespace hair

#include <libhair/density/density_map.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

void validate(const DensityMapSettings& s) {
  require(s.cells >= 2 && s.cells <= 1024, "cells: ", s.cells, " is not in 2 to 1024");
  require(s.cellSize >= 1e-6f && s.cellSize <= 1e6f, "density map: cell size ", s.cellSize,
          " m is not in 1e-6 to 1e6");
  require(s.filter != Filter::Footprint || (s.footprint >= 0 && s.footprint <= 10 * s.cellSize),
          "density map: footprint ", s.footprint, " m is not in 0 to 10 cells of ", s.cellSize,
          " m; take larger cells");
  require(s.pointExtinction >= 0 && std::isfinite(s.pointExtinction),
          "density map: point extinction ", s.pointExtinction, " is negative or not finite");
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

int DensityMap::depth() const {
  if (empty()) return 0;
  return static_cast<int>(
      std::min<std::int64_t>(std::int64_t{upper.x} - lower.x + 1, settings.cells));
}

bool DensityMap::aliased() const {
  if (empty()) return false;
  for (int c = 0; c < 3; ++c)
    if (std::int64_t{upper[c]} - lower[c] >= settings.cells) return true;
  return false;
}

std::size_t DensityMap::bytes() const {
  return bricks.bytes() +
         (bricks.size() + 1) * Transmittances::kLayers * Transmittances::kLayer * sizeof(float) +
         lightIn.size() * sizeof(lightIn[0]);
}

float DensityMap::density(glm::ivec3 cell) const {
  if (glm::any(glm::lessThan(cell, lower)) || glm::any(glm::greaterThan(cell, upper))) return 0;
  const float volume = settings.cellSize * settings.cellSize * settings.cellSize;
  return static_cast<float>(count(cell)) * (quantum / volume);
}

void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light) {
  validate(settings);
  if (!map.bricks.valid() || map.settings.cells != settings.cells) {
    map.bricks = BrickStore(settings.cells);
    map.workers.clear();
  } else {
    map.bricks.clear();
    // Empty but after an exception.
    for (BrickStore& worker : map.workers) worker.clear();
  }
  map.saturatedCells = 0;
  map.settings = settings;
  map.light = light;
  map.frame = makeCellFrame(light, glm::vec3(0), settings.cellSize, settings.cells);
  map.quantum = 0;
  map.lit = false;
  map.fibreShadow = 0;
  map.lower = glm::ivec3(INT_MAX);
  map.upper = glm::ivec3(INT_MIN);
}

DensitySample sampleDensity(const DensityMap& map, glm::vec3 p) {
  if (map.empty()) return {};
  const glm::vec3 u = map.frame.cellCoordinates(p) - 0.5f;
  const glm::ivec3 c(floorToInt(u.x), floorToInt(u.y), floorToInt(u.z));
  const glm::vec3 f = u - glm::vec3(c);
  // As DensityMap::density of the eight cells, each axis wrapped once.
  glm::ivec3 at[2];
  glm::bvec3 inside[2];
  for (int k = 0; k < 2; ++k) {
    at[k] = map.wrap(c + k);
    inside[k] = glm::bvec3(glm::ivec3(glm::greaterThanEqual(c + k, map.lower)) *
                           glm::ivec3(glm::lessThanEqual(c + k, map.upper)));
  }
  const float cellSize = map.settings.cellSize;
  const float perCount = map.quantum / (cellSize * cellSize * cellSize);
  float d[2][2][2];
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z)
        d[x][y][z] =
            inside[x].x && inside[y].y && inside[z].z
                ? static_cast<float>(map.bricks.count({at[x].x, at[y].y, at[z].z})) * perCount
                : 0.0f;
  // Along z, then y, then x; a derivative replaces the mean of two values by their difference.
  float alongZ[2][2], alongY[2], acrossY[2], acrossZ[2];
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) alongZ[x][y] = glm::mix(d[x][y][0], d[x][y][1], f.z);
    alongY[x] = glm::mix(alongZ[x][0], alongZ[x][1], f.y);
    acrossY[x] = alongZ[x][1] - alongZ[x][0];
    acrossZ[x] = glm::mix(d[x][0][1] - d[x][0][0], d[x][1][1] - d[x][1][0], f.y);
  }
  const glm::vec3 perCell(alongY[1] - alongY[0], glm::mix(acrossY[0], acrossY[1], f.x),
                          glm::mix(acrossZ[0], acrossZ[1], f.x));
  // d/dworld = (dcell/dworld)^T d/dcell.
  return {glm::mix(alongY[0], alongY[1], f.x), glm::transpose(map.frame.cellFromWorld) * perCell};
}

}  // namespace hair

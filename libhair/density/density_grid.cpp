#include <libhair/density/density_grid.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/grid_cells.h>

namespace hair {

void validate(const DensityGridSettings& s) {
  validateFields(s, "density grid");
}

DensityGrid::DensityGrid() : cells(std::make_unique<GridCells>()) {}
DensityGrid::~DensityGrid() = default;
DensityGrid::DensityGrid(DensityGrid&&) noexcept = default;
DensityGrid& DensityGrid::operator=(DensityGrid&&) noexcept = default;

std::size_t DensityGrid::bytes() const {
  return cells->bricks.bytes();
}

std::size_t DensityGrid::brickCount() const {
  return cells->bricks.size();
}

glm::ivec3 DensityGrid::wrap(glm::ivec3 cell) const {
  const glm::ivec3 base = cells->frame.base;
  return {wrap(base.x + cell.x), wrap(base.y + cell.y), wrap(base.z + cell.z)};
}

std::uint32_t DensityGrid::count(glm::ivec3 cell) const {
  return cells->bricks.count(wrap(cell));
}

glm::ivec3 DensityGrid::cellOf(glm::vec3 p) const {
  const glm::vec3 u = cells->frame.cellCoordinates(p);
  return {floorToInt(u.x), floorToInt(u.y), floorToInt(u.z)};
}

glm::vec3 DensityGrid::cellCentre(glm::ivec3 cell) const {
  return cells->frame.point(glm::vec3(cell) + 0.5f);
}

int DensityGrid::depth() const {
  if (empty()) return 0;
  return static_cast<int>(
      std::min<std::int64_t>(std::int64_t{upper.x} - lower.x + 1, settings.cells));
}

bool DensityGrid::aliased() const {
  if (empty()) return false;
  for (int c = 0; c < 3; ++c)
    if (std::int64_t{upper[c]} - lower[c] >= settings.cells) return true;
  return false;
}

float DensityGrid::density(glm::ivec3 cell) const {
  if (glm::any(glm::lessThan(cell, lower)) || glm::any(glm::greaterThan(cell, upper))) return 0;
  const float volume = settings.cellSize * settings.cellSize * settings.cellSize;
  return static_cast<float>(count(cell)) * (quantum / volume);
}

void clear(DensityGrid& grid, const DensityGridSettings& settings, const GridSpace& space) {
  validate(settings);
  GridCells& cells = *grid.cells;
  if (!cells.bricks.valid() || grid.settings.cells != settings.cells) {
    cells.bricks = BrickStore(settings.cells);
    cells.workers.clear();
  } else {
    cells.bricks.clear();
    // Non-empty only after an exception.
    for (BrickStore& worker : cells.workers) worker.clear();
  }
  grid.saturatedCells = 0;
  grid.settings = settings;
  grid.space = space;
  cells.frame = makeCellFrame(space, glm::vec3(0), settings.cellSize, settings.cells);
  grid.quantum = 0;
  grid.lower = glm::ivec3(INT_MAX);
  grid.upper = glm::ivec3(INT_MIN);
}

DensitySample sampleDensity(const DensityGrid& grid, glm::vec3 p) {
  if (grid.empty()) return {};
  const GridCells& cells = *grid.cells;
  const glm::vec3 u = cells.frame.cellCoordinates(p) - 0.5f;
  const glm::ivec3 c(floorToInt(u.x), floorToInt(u.y), floorToInt(u.z));
  const glm::vec3 f = u - glm::vec3(c);
  // DensityGrid::density of eight cells; wraps each axis once for all of them.
  glm::ivec3 at[2];
  glm::bvec3 inside[2];
  for (int k = 0; k < 2; ++k) {
    at[k] = grid.wrap(c + k);
    inside[k] = glm::bvec3(glm::ivec3(glm::greaterThanEqual(c + k, grid.lower)) *
                           glm::ivec3(glm::lessThanEqual(c + k, grid.upper)));
  }
  const float cellSize = grid.settings.cellSize;
  const float perCount = grid.quantum / (cellSize * cellSize * cellSize);
  float d[2][2][2];
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z)
        d[x][y][z] =
            inside[x].x && inside[y].y && inside[z].z
                ? static_cast<float>(cells.bricks.count({at[x].x, at[y].y, at[z].z})) * perCount
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
  return {glm::mix(alongY[0], alongY[1], f.x), glm::transpose(cells.frame.cellFromWorld) * perCell};
}

}  // namespace hair

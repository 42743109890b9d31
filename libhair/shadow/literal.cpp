#include <libhair/shadow/literal.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include <libhair/density/grid_cells.h>
#include <libhair/shadow/footprint.h>

namespace hair::literal {

namespace {

int floorMod(int a, int n) {
  return ((a % n) + n) % n;
}

glm::ivec3 wrapped(const LiteralMap& map, glm::vec3 u) {
  glm::ivec3 cell;
  for (int c = 0; c < 3; ++c)
    cell[c] = floorMod(map.frame.base[c] + static_cast<int>(std::floor(u[c])), map.cells);
  return cell;
}

std::size_t at(const LiteralMap& map, int i, int j, int k) {
  const auto n = static_cast<std::size_t>(map.cells);
  return (static_cast<std::size_t>(i) * n + static_cast<std::size_t>(j)) * n +
         static_cast<std::size_t>(k);
}

/// Equation 3: transmittance at the back face of an unwrapped cell.
double leaving(const DensityGrid& grid, glm::ivec3 cell) {
  double depth = 0;
  const bool beside = cell.y < grid.lower.y || cell.y > grid.upper.y || cell.z < grid.lower.z ||
                      cell.z > grid.upper.z;
  for (int i = grid.lower.x; !beside && i <= std::min(cell.x, grid.upper.x); ++i)
    depth += static_cast<double>(grid.quantum) * grid.count({i, cell.y, cell.z});
  return std::exp(-depth);
}

/// Transmittance at depth x of a column: linear between front and back face of its cell.
double reaching(const DensityGrid& grid, double x, int j, int k) {
  const int i = static_cast<int>(std::floor(x));
  return std::lerp(leaving(grid, {i - 1, j, k}), leaving(grid, {i, j, k}), x - i);
}

/// Filters of section 3.3: linear across the light, with the value of cell j, k located at
/// (j + shift, k + shift).
double linear(const DensityGrid& grid, glm::dvec3 u, double shift) {
  const double y = u.y - shift, z = u.z - shift;
  const int j = static_cast<int>(std::floor(y)), k = static_cast<int>(std::floor(z));
  const auto row = [&](int z0) {
    return std::lerp(reaching(grid, u.x, j, z0), reaching(grid, u.x, j + 1, z0), y - j);
  };
  return std::lerp(row(k), row(k + 1), z - k);
}

/// Integral of the tent function of half-width 1, from -1 to t.
double tentBelow(double t) {
  t = std::clamp(t, -1.0, 1.0);
  return t < 0 ? 0.5 * (1 + t) * (1 + t) : 1 - 0.5 * (1 - t) * (1 - t);
}

/// Filter::Footprint: the mean of `linear` between cell centres over a square of side 2 h
/// (FootprintKernel), as a sum over cells.
double footprint(const DensityGrid& grid, glm::dvec3 u, double h) {
  const auto weight = [h](double from, int cell) {
    const double t = from - (cell + 0.5);
    return (tentBelow(t + h) - tentBelow(t - h)) / (2 * h);
  };
  const auto first = [h](double from) { return static_cast<int>(std::floor(from - h - 1.5)); };
  const auto last = [h](double from) { return static_cast<int>(std::ceil(from + h + 0.5)); };
  double sum = 0;
  for (int k = first(u.z); k <= last(u.z); ++k)
    for (int j = first(u.y); j <= last(u.y); ++j)
      sum += weight(u.y, j) * weight(u.z, k) * reaching(grid, u.x, j, k);
  return sum;
}

}  // namespace

void fillDensity(std::span<const glm::vec3> points, const LightSpace& light, LiteralMap& map) {
  const auto n = static_cast<std::size_t>(map.cells), cellCount = n * n * n;
  map.density.assign(cellCount, 0.0f);
  map.transmittance.resize(cellCount);
  if (points.empty()) return;
  map.frame = makeCellFrame(light, points.front(), map.cellSize, map.cells);
  int nearest = INT_MAX;
  for (glm::vec3 p : points) {
    const glm::vec3 u = map.frame.cellCoordinates(p);
    const glm::ivec3 cell = wrapped(map, u);
    map.density[at(map, cell.x, cell.y, cell.z)] += 1.0f;
    nearest = std::min(nearest, static_cast<int>(std::floor(u.x)));
  }
  map.firstSlice = floorMod(map.frame.base.x + nearest, map.cells);
}

void computeTransmittance(LiteralMap& map) {
  for (int j = 0; j < map.cells; ++j)
    for (int k = 0; k < map.cells; ++k) {
      float prevTrans = 1;
      for (int s = 0; s < map.cells; ++s) {
        const int i = (map.firstSlice + s) % map.cells;
        const std::size_t cell = at(map, i, j, k);
        prevTrans *= std::exp(-map.density[cell] * map.extinction * map.cellSize);
        map.transmittance[cell] = prevTrans;
      }
    }
}

void filterTransmittance(const LiteralMap& map, std::span<const glm::vec3> points,
                         std::span<float> out) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 u = map.frame.cellCoordinates(points[p]);
    const glm::ivec3 cell = wrapped(map, u);
    const glm::vec3 lambda = u - glm::floor(u);
    float sum = 0;
    for (int di = 0; di < 2; ++di)
      for (int dj = 0; dj < 2; ++dj)
        for (int dk = 0; dk < 2; ++dk) {
          const float weight = (di == 0 ? lambda.x : 1 - lambda.x) *
                               (dj == 0 ? lambda.y : 1 - lambda.y) *
                               (dk == 0 ? lambda.z : 1 - lambda.z);
          const bool inFront = di == 1 && cell.x == map.firstSlice;
          const float trans = inFront ? 1.0f
                                      : map.transmittance[at(map, floorMod(cell.x - di, map.cells),
                                                             floorMod(cell.y - dj, map.cells),
                                                             floorMod(cell.z - dk, map.cells))];
          sum += weight * trans;
        }
    out[p] = sum;
  }
}

double transmittance(const DensityMap& map, glm::vec3 p) {
  const DensityGrid& grid = map.grid;
  const glm::vec3 u = grid.cells->frame.cellCoordinates(p);
  switch (map.settings.filter) {
    case Filter::None:
      return leaving(grid, grid.cellOf(p));
    case Filter::Paper:
      return linear(grid, u, 1);
    case Filter::Centred:
      return linear(grid, u, 0.5);
    case Filter::Footprint:
      return footprint(grid, u, static_cast<double>(FootprintKernel(map.settings).halfWidth));
  }
  return 1;
}

}  // namespace hair::literal

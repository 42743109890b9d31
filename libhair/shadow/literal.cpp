#include <libhair/shadow/literal.h>

#include <algorithm>
#include <climits>
#include <cmath>

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

}  // namespace hair::literal

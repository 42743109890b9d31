#include <libhair/measure/shadow/cell_lists.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

namespace {

/// Largest number of cells: more are mostly empty, and miss the cache.
double mostCells(std::size_t segments) {
  return std::min(32.0 * static_cast<double>(segments) + 65536.0, 0x1p25);
}

glm::ivec3 cellOf(const CellLists& grid, glm::dvec3 p) {
  const glm::dvec3 c = glm::floor((p - grid.lower) / grid.cell);
  return glm::ivec3(glm::clamp(c, glm::dvec3(0), glm::dvec3(grid.size - 1)));
}

/// Calls visit(cell index) for all cells that come within `radius` of the segment, and some more:
/// slab by slab along the axis on which it is longest, the box around what of it is near the slab.
template <class Visit>
void forCells(const CellLists& grid, glm::dvec3 a, glm::dvec3 b, double radius, Visit&& visit) {
  const glm::dvec3 way = b - a, length = glm::abs(way);
  const int axis = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
  const glm::ivec3 lower = cellOf(grid, glm::min(a, b) - radius);
  const glm::ivec3 upper = cellOf(grid, glm::max(a, b) + radius);
  for (int slab = lower[axis]; slab <= upper[axis]; ++slab) {
    double from = 0, to = 1;
    if (way[axis] != 0) {
      const double front = grid.lower[axis] + slab * grid.cell;
      const double t0 = (front - radius - a[axis]) / way[axis];
      const double t1 = (front + grid.cell + radius - a[axis]) / way[axis];
      from = std::clamp(std::min(t0, t1), 0.0, 1.0);
      to = std::clamp(std::max(t0, t1), 0.0, 1.0);
    }
    const glm::dvec3 p = a + from * way, q = a + to * way;
    glm::ivec3 least = cellOf(grid, glm::min(p, q) - radius);
    glm::ivec3 most = cellOf(grid, glm::max(p, q) + radius);
    least[axis] = most[axis] = slab;
    for (int z = least.z; z <= most.z; ++z)
      for (int y = least.y; y <= most.y; ++y)
        for (int x = least.x; x <= most.x; ++x) visit(grid.index({x, y, z}));
  }
}

}  // namespace

CellLists makeCellLists(std::span<const glm::vec3> points, std::span<const std::uint32_t> segments,
                        double radius, double cell, int axes) {
  CellLists grid;
  if (segments.empty()) return grid;
  glm::dvec3 lower(INFINITY), upper(-INFINITY);
  for (const std::uint32_t i : segments)
    for (const glm::dvec3 p : {glm::dvec3(points[i]), glm::dvec3(points[i + 1])})
      lower = glm::min(lower, p), upper = glm::max(upper, p);
  for (int c = 0; c < axes; ++c) lower[c] -= radius, upper[c] += radius;

  grid.lower = lower;
  grid.cell = cell;
  glm::dvec3 size;
  const auto measure = [&] {
    size = glm::floor((upper - lower) / grid.cell) + 1.0;
    return size.x * size.y * size.z > mostCells(segments.size());
  };
  while (measure()) grid.cell *= 1.25;
  grid.size = glm::ivec3(size);

  // Count, sum up, fill.
  const std::size_t cells = static_cast<std::size_t>(size.x * size.y * size.z);
  grid.start.assign(cells + 1, 0);
  for (const std::uint32_t i : segments)
    forCells(grid, points[i], points[i + 1], radius, [&](std::size_t c) { ++grid.start[c + 1]; });
  std::uint64_t sum = 0;
  for (std::uint32_t& s : grid.start) {
    sum += s;
    require(sum <= 0xffffffffu, "tracer: more than 2^32 cells of segments; trace fewer strands");
    s = static_cast<std::uint32_t>(sum);
  }
  grid.items.resize(sum);
  std::vector<std::uint32_t> next(grid.start.begin(), grid.start.end() - 1);
  for (const std::uint32_t i : segments)
    forCells(grid, points[i], points[i + 1], radius,
             [&](std::size_t c) { grid.items[next[c]++] = i; });
  return grid;
}

}  // namespace hair

#include <libhair/shadow/density_map.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/cell_walk.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/grid_cells.h>

namespace hair {

namespace {

// exp(-90) is 0 within the precision of the map.
constexpr float kOpaque = 90;

/// Bounds in cells of an object inside a sphere. Under a point light the mapping is curved: sample
/// the sphere, widened by 2 %, at many points.
struct CellBox {
  glm::ivec3 lower, upper;
};

CellBox cellBox(const CellFrame& frame, glm::vec3 centre, float radius) {
  Bounds box;
  constexpr int kSteps = 6;
  for (int x = -kSteps; x <= kSteps; ++x)
    for (int y = -kSteps; y <= kSteps; ++y)
      for (int z = -kSteps; z <= kSteps; ++z) {
        const glm::vec3 to(x, y, z);
        if (to != glm::vec3(0))
          box.extend(frame.cellCoordinates(centre + 1.02f * radius * glm::normalize(to)));
      }
  return {floorToCell(box.lower), floorToCell(box.upper)};
}

/// Clips a box to the cells that do not wrap around onto the hair, so that distant objects (a leg,
/// things next to a lamp) do not alias.
CellBox roomFor(CellBox box, const DensityGrid& grid) {
  const int n = grid.settings.cells;
  const glm::ivec3 middle = (box.lower + box.upper) / 2;
  for (int c = 0; c < 3; ++c) {
    const int least = grid.empty() ? middle[c] - n / 2 : grid.upper[c] - n + 1;
    const int most = grid.empty() ? least + n - 1 : grid.lower[c] + n - 1;
    // Objects in front of the map cast shadows too: they are moved to its first slice.
    if (c > 0) box.lower[c] = std::max(box.lower[c], least);
    box.upper[c] = std::min({box.upper[c], most, std::max(box.lower[c], least) + n - 1});
  }
  // Nothing behind all hair can shadow it.
  if (!grid.empty()) box.upper.x = std::min(box.upper.x, grid.upper.x);
  return box;
}

/// distance(p): signed distance, metres, negative inside, at most the true distance.
template <class Distance>
void occlude(const Distance& distance, glm::vec3 centre, float radius, DensityMap& map) {
  DensityGrid& grid = map.grid;
  require(grid.cells->bricks.valid(), "occlude: clear() the density map first");
  const float cell = grid.settings.cellSize;
  if (grid.empty()) {
    grid.cells->frame = makeCellFrame(grid.space, centre, cell, grid.settings.cells);
    grid.quantum = kQuantum;
  }
  const CellFrame frame = grid.cells->frame;
  require(
      grid.quantum > 0,
      "occlude: a point of this hair is worth no optical depth; take Deposit::Columns, or fibres "
      "of some width and opacity");
  const auto count =
      static_cast<std::uint32_t>(std::min(std::max(kOpaque / grid.quantum, 1.0f), 4294967040.0f));
  const CellBox box = roomFor(cellBox(frame, centre, radius), grid);
  const int firstSlice = grid.empty() ? box.lower.x : grid.upper.x - grid.settings.cells + 1;
  if (glm::any(glm::greaterThan(box.lower, box.upper))) return;
  map.lit = false;
  const auto rows = static_cast<std::size_t>(box.upper.z - box.lower.z) + 1;
  // A few steps a column, of some tens of nanoseconds each.
  const std::size_t nanoseconds =
      rows * (static_cast<std::size_t>(box.upper.y - box.lower.y) + 1) * 100;
  writeCells(rows, 4, nanoseconds, grid,
             [&](CellWriter& writer, std::size_t begin, std::size_t end) {
               for (std::size_t row = begin; row < end; ++row) {
                 const int k = box.lower.z + static_cast<int>(row);
                 for (int j = box.lower.y; j <= box.upper.y; ++j) {
                   for (int i = box.lower.x; i <= box.upper.x;) {
                     const glm::vec3 front(static_cast<float>(i), static_cast<float>(j) + 0.5f,
                                           static_cast<float>(k) + 0.5f);
                     const float d = distance(frame.point(front)) / cell;
                     if (d <= -0.5f) {
                       const glm::ivec3 first(std::max(i, firstSlice), j, k);
                       writer.extend(first, first);
                       writer.add(first, count);
                       break;
                     }
                     i += std::max(static_cast<int>(d), 1);
                   }
                 }
               }
             });
}

}  // namespace

void occlude(const MeshSdf& mesh, const RigidTransform& worldFromMesh, DensityMap& map) {
  const RigidTransform meshFromWorld = inverse(worldFromMesh);
  const Bounds& box = mesh.box();
  occlude([&](glm::vec3 p) { return mesh.distance(meshFromWorld.point(p)); },
          worldFromMesh.point(box.centre()), 0.5f * glm::length(box.size()), map);
}

void occlude(std::span<const Capsule> capsules, DensityMap& map) {
  for (const Capsule& c : capsules)
    occlude([&](glm::vec3 p) { return std::sqrt(axisDistance2(c, p)) - c.radius; },
            0.5f * (c.a + c.b), 0.5f * glm::distance(c.a, c.b) + c.radius, map);
}

}  // namespace hair

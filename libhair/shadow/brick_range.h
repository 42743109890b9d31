#pragma once

#include <cstddef>
#include <cstdint>

#include <libhair/density/density_grid.h>
#include <libhair/density/grid_cells.h>

namespace hair {

/// Consecutive bricks along an axis, wrapping from the last to the first.
struct BrickRange {
  int begin, count, perAxis;

  std::size_t at(int i) const {
    return static_cast<std::size_t>(begin + i < perAxis ? begin + i : begin + i - perAxis);
  }
};

/// Bricks across the light (axis 1 or 2) that a filter may read: the hair's, plus a margin for
/// footprints that overlap the hair, 2 · 10 + 2 cells at most.
inline BrickRange bricksToRead(const DensityGrid& grid, int axis) {
  constexpr int kBeside = 24;
  const int perAxis = grid.cells->bricks.perAxis()[axis];
  const int size = axis == 1 ? brick::kY : brick::kZ;
  const std::int64_t cells = std::int64_t{grid.upper[axis]} - grid.lower[axis] + 1 + 2 * kBeside;
  // No brick may occur twice.
  if (grid.empty() || cells + size > grid.settings.cells) return {0, perAxis, perAxis};
  const int base = grid.cells->frame.base[axis];
  const int first = grid.wrap(base + grid.lower[axis] - kBeside) / size;
  const int last = grid.wrap(base + grid.upper[axis] + kBeside) / size;
  return {first, (last - first + perAxis) % perAxis + 1, perAxis};
}

}  // namespace hair

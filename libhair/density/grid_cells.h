#pragma once

#include <vector>

#include <libhair/density/brick_store.h>
#include <libhair/density/cell_frame.h>

namespace hair {

/// The cells of a DensityGrid. Loops take a reference to it once, not for each point.
struct GridCells {
  CellFrame frame;                  ///< from points to cells
  BrickStore bricks;                ///< counts: fixed-point amounts
  std::vector<BrickStore> workers;  ///< of other threads, empty after deposit()
};

}  // namespace hair

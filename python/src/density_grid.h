#pragma once

#include <libhair/density/density_grid.h>

#include "strands.h"

namespace hair::python {

/// Points of Python's, (N, 3) float32. Throws Error for some that are not finite.
py::array placesIn(const py::object& points);

// What a grid holds, as arrays of Python's.

/// Density and its gradient at points: (N,) and (N, 3) float32.
py::tuple densityAt(const DensityGrid& grid, const py::object& points);
/// Density of all cells between `lower` and `upper`, both included: (I, J, K) float32. Throws Error
/// where ends of the hair share cells.
py::array densityOfCells(const DensityGrid& grid);
/// The middles of the same cells: (I, J, K, 3) float32.
py::array centresOfCells(const DensityGrid& grid);

}  // namespace hair::python

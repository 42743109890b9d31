// How much hair is where.
#include "density_grid.h"

#include <cmath>
#include <optional>

#include <libhair/core/error.h>
#include <libhair/density/density_grid.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

namespace {

// Of all cells between `lower` and `upper`, both included.
template <class Scalar, class T, class Of>
py::array ofCells(const DensityGrid& grid, const Shape& inner, Of&& of) {
  require(!grid.aliased(),
          "density: the hair is larger than the grid, its ends share cells; take more or larger "
          "cells");
  const glm::ivec3 lower = grid.empty() ? glm::ivec3(0) : grid.lower;
  const glm::ivec3 size = grid.empty() ? glm::ivec3(0) : grid.upper - grid.lower + 1;
  std::vector<T> cells;
  cells.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                static_cast<std::size_t>(size.z));
  for (int i = 0; i < size.x; ++i)
    for (int j = 0; j < size.y; ++j)
      for (int k = 0; k < size.z; ++k) cells.push_back(of(lower + glm::ivec3(i, j, k)));
  Shape shape = {size.x, size.y, size.z};
  shape.insert(shape.end(), inner.begin(), inner.end());
  return arrayOf<Scalar>(std::move(cells), shape);
}

class Grid {
 public:
  explicit Grid(const DensityGridSettings& settings) { hair::clear(grid_, settings); }

  void clear(const std::optional<DensityGridSettings>& settings) {
    const Busy busy(busy_, "density grid");
    const DensityGridSettings next = settings.value_or(grid_.settings);
    withoutLock([&] { hair::clear(grid_, next); });
  }
  void deposit(const Strands& strands, float hairsPerStrand, std::uint32_t stride) {
    const Busy busy(busy_, "density grid");
    const StrandView view = strands.view();
    withoutLock([&] { hair::deposit(view, metresOfHair(hairsPerStrand), grid_, stride); });
  }
  py::tuple density(const py::object& points) {
    const Busy busy(busy_, "density grid");
    return densityAt(grid_, points);
  }
  py::array densityGrid() {
    const Busy busy(busy_, "density grid");
    return densityOfCells(grid_);
  }
  py::array cellCentres() {
    const Busy busy(busy_, "density grid");
    return centresOfCells(grid_);
  }
  const DensityGrid& grid() const { return grid_; }

 private:
  DensityGrid grid_;
  bool busy_ = false;
};

}  // namespace

py::array placesIn(const py::object& points) {
  const py::array in = requirePoints(points, "points");
  for (const glm::vec3 p : pointsOf(in))
    require(std::abs(p.x) < 1e8f && std::abs(p.y) < 1e8f && std::abs(p.z) < 1e8f,
            "points: not finite, or beyond 1e8 m (check the scale)");
  return in;
}

py::tuple densityAt(const DensityGrid& grid, const py::object& points) {
  const py::array in = placesIn(points);
  std::vector<float> densities;
  std::vector<glm::vec3> gradients;
  for (const glm::vec3 p : pointsOf(in)) {
    const DensitySample sample = sampleDensity(grid, p);
    densities.push_back(sample.density);
    gradients.push_back(sample.gradient);
  }
  return py::make_tuple(arrayOf<float>(std::move(densities), {in.shape(0)}),
                        arrayOfPoints(std::move(gradients)));
}

py::array densityOfCells(const DensityGrid& grid) {
  return ofCells<float, float>(grid, {}, [&](glm::ivec3 cell) { return grid.density(cell); });
}

py::array centresOfCells(const DensityGrid& grid) {
  return ofCells<float, glm::vec3>(grid, {3},
                                   [&](glm::ivec3 cell) { return grid.cellCentre(cell); });
}

void bindDensity(py::module_& m) {
  py::class_<Grid>(
      m, "DensityGrid",
      R"(How much hair is where: metres of hair in the cells of a grid, as the world's axes.

clear(), deposit() as often as there is hair, then density() or density_grid().)")
      .def(py::init<const DensityGridSettings&>(), py::arg("settings") = DensityGridSettings{},
           "An empty grid.")
      .def("clear", &Grid::clear, py::arg("settings") = py::none(),
           "Forgets what was deposited; settings that are not given stay. Keeps its memory.")
      .def(
          "deposit", &Grid::deposit, py::arg("strands"), py::arg("hairs_per_strand") = 1.0f,
          py::arg("stride") = 1u,
          "Adds strands, each for so many hairs. stride: every so many strands are read, and count "
          "for that many.")
      .def("density", &Grid::density, py::arg("points"),
           "Density at points (N, 3) float32, and its gradient: (N,) float32, metres of hair per "
           "m³, "
           "and (N, 3) float32, per metre.")
      .def("density_grid", &Grid::densityGrid,
           "Density of all cells that hold hair and those between, (I, J, K) float32; a copy.")
      .def("cell_centres", &Grid::cellCentres,
           "Where the middles of the cells of density_grid are, (I, J, K, 3) float32, metres.")
      .def_property_readonly(
          "settings", [](const Grid& grid) { return grid.grid().settings; }, "A copy.")
      .def_property_readonly(
          "lower", [](const Grid& grid) { return grid.grid().lower; },
          "Least cell (i, j, k) that holds hair, counted from the cell of the first point.")
      .def_property_readonly(
          "upper", [](const Grid& grid) { return grid.grid().upper; }, "Greatest cell (i, j, k).")
      .def_property_readonly(
          "empty", [](const Grid& grid) { return grid.grid().empty(); }, "Nothing was deposited.")
      .def_property_readonly(
          "aliased", [](const Grid& grid) { return grid.grid().aliased(); },
          "The hair is larger than the grid: take more or larger cells.")
      .def_property_readonly(
          "saturated_cells", [](const Grid& grid) { return grid.grid().saturatedCells; },
          "Cells whose sum did not fit.")
      .def_property_readonly(
          "bytes", [](const Grid& grid) { return grid.grid().bytes(); }, "Memory of what it holds.")
      .def("__repr__", [](const Grid& grid) {
        const DensityGridSettings& s = grid.grid().settings;
        return text("<DensityGrid: ", s.cells, "³ cells of ", 1000 * s.cellSize, " mm, ",
                    grid.grid().brickCount(), " bricks>");
      });
}

}  // namespace hair::python

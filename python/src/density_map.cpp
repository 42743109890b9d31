// The density map, pass by pass.
#include <libhair/core/error.h>
#include <libhair/shadow/density_map.h>

#include "choices.h"
#include "density_grid.h"
#include "shadow.h"

namespace hair::python {

namespace {

/// A DensityMap that knows which pass is next.
class Map {
 public:
  Map(const DensityMapSettings& settings, const Light& light, glm::vec3 pivot)
      : settings_(settings), light_(light), pivot_(pivot) {
    clear({}, {}, {});
  }

  void clear(const std::optional<DensityMapSettings>& settings, const std::optional<Light>& light,
             const std::optional<glm::vec3>& pivot) {
    const Busy busy(busy_, "density map");
    const DensityMapSettings nextSettings = settings.value_or(settings_);
    const Light nextLight = light.value_or(light_);
    const glm::vec3 nextPivot = pivot.value_or(pivot_);
    withoutLock([&] { hair::clear(map_, nextSettings, lightSpaceOf(nextLight, nextPivot)); });
    settings_ = nextSettings, light_ = nextLight, pivot_ = nextPivot;
  }
  void deposit(const Strands& strands, const std::optional<Fibre>& fibre, std::uint32_t stride) {
    const Busy busy(busy_, "density map");
    const StrandView view = strands.view();
    withoutLock([&] { hair::deposit(view, fibreFor(fibre, view), map_, stride); });
  }
  void occludeField(const Field& field, const RigidTransform& worldFromMesh) {
    const Busy busy(busy_, "density map");
    withoutLock([&] { occlude(*field, worldFromMesh, map_); });
  }
  void occludeCapsules(const py::object& capsules) {
    const Busy busy(busy_, "density map");
    const auto rows = rowsOf<Capsule>(capsules, "capsules");
    withoutLock([&] { occlude(rows, map_); });
  }
  void computeTransmittance() {
    const Busy busy(busy_, "density map");
    withoutLock([&] { hair::computeTransmittance(map_); });
  }
  py::array sample(const py::object& points, const py::object& out) {
    const Busy busy(busy_, "density map");
    const py::array in = placesIn(points);
    const py::array result = outputOf<float>(out, {in.shape(0)});
    const auto to = spanOf<float, float>(result);
    withoutLock([&] { sampleTransmittance(map_, pointsOf(in), to); });
    return result;
  }
  py::array sampleStrands(const Strands& strands, const py::object& out) {
    const Busy busy(busy_, "density map");
    const StrandView view = strands.view();
    const py::array result = outputOf<float>(out, {strands.points.shape(0)});
    const auto to = spanOf<float, float>(result);
    withoutLock([&] { sampleStrandTransmittance(map_, view, to); });
    return result;
  }
  py::tuple density(const py::object& points) {
    const Busy busy(busy_, "density map");
    return densityAt(map_.grid, points);
  }
  py::array densityGrid() {
    const Busy busy(busy_, "density map");
    return densityOfCells(map_.grid);
  }
  py::array cellCentres() {
    const Busy busy(busy_, "density map");
    return centresOfCells(map_.grid);
  }
  const DensityMap& map() const { return map_; }
  const Light& light() const { return light_; }

 private:
  DensityMap map_;
  DensityMapSettings settings_;
  Light light_;
  glm::vec3 pivot_;
  bool busy_ = false;
};

}  // namespace

void bindDensityMap(py::module_& m) {
  py::class_<Map>(m, "DensityMap",
                  R"(Hair density and transmittance on a grid that is turned to the light.

A frame: clear(), deposit() as often as there is hair, occlude() what else is there,
compute_transmittance(), then sample() or sample_strands().)")
      .def(py::init<const DensityMapSettings&, const Light&, glm::vec3>(), py::arg("settings"),
           py::arg("light"), py::arg("pivot") = glm::vec3(0),
           "An empty map. pivot: what a light at a point looks at, metres.")
      .def("clear", &Map::clear, py::arg("settings") = py::none(), py::arg("light") = py::none(),
           py::arg("pivot") = py::none(),
           "Forgets what was deposited; what is not given stays. Keeps its memory.")
      .def("deposit", &Map::deposit, py::arg("strands"), py::arg("fibre") = py::none(),
           py::arg("stride") = 1u,
           "Adds strands. stride: every so many strands are read, and count for that many.")
      .def("occlude", &Map::occludeField, py::arg("field").none(false),
           py::arg("world_from_mesh") = RigidTransform{},
           "Adds an opaque thing: a DistanceField at a Transform.")
      .def("occlude_capsules", &Map::occludeCapsules, py::arg("capsules"),
           "Adds opaque capsules (C, 7), each a, b and radius, metres.")
      .def("compute_transmittance", &Map::computeTransmittance,
           "From densities to transmittance, once all is deposited.")
      .def("sample", &Map::sample, py::arg("points"), py::arg("out") = py::none(),
           "Transmittance at points (N, 3) float32: (N,) float32, [0, 1]; in `out` if given.")
      .def("sample_strands", &Map::sampleStrands, py::arg("strands"), py::arg("out") = py::none(),
           "At the points of strands that were deposited, without a strand's own shadow: (N,) "
           "float32.")
      .def("density", &Map::density, py::arg("points"),
           "Density of optical depth at points (N, 3) float32, and its gradient: (N,) float32, "
           "1/m³, "
           "and (N, 3) float32, per metre.")
      .def("density_grid", &Map::densityGrid,
           "Density of all cells that hold hair and those between, (I, J, K) float32, I along the "
           "light; a copy.")
      .def("cell_centres", &Map::cellCentres,
           "Where the middles of the cells of density_grid are, (I, J, K, 3) float32, metres.")
      .def_property_readonly(
          "settings", [](const Map& map) { return map.map().settings; }, "A copy.")
      .def_property_readonly("light", &Map::light, "The Light.")
      .def_property_readonly(
          "lower", [](const Map& map) { return map.map().grid.lower; },
          "Least cell (i, j, k) that holds hair, counted from the cell of the first point.")
      .def_property_readonly(
          "upper", [](const Map& map) { return map.map().grid.upper; }, "Greatest cell (i, j, k).")
      .def_property_readonly(
          "empty", [](const Map& map) { return map.map().empty(); }, "Nothing was deposited.")
      .def_property_readonly(
          "aliased", [](const Map& map) { return map.map().aliased(); },
          "The hair is larger than the map: take more or larger cells.")
      .def_property_readonly(
          "saturated_cells", [](const Map& map) { return map.map().grid.saturatedCells; },
          "Cells whose sum did not fit.")
      .def_property_readonly(
          "bytes", [](const Map& map) { return map.map().bytes(); }, "Memory of what it holds.")
      .def("__repr__", [](const Map& map) {
        const DensityMapSettings& s = map.map().settings;
        return text("<DensityMap: ", s.cells, "³ cells of ", 1000 * s.cellSize, " mm, ",
                    map.map().grid.brickCount(), " bricks>");
      });
}

}  // namespace hair::python

// How much of a groom is drawn.
#include "level_of_detail.h"

#include <libhair/wisps/wisps.h>

#include "fields.h"
#include "groom.h"
#include "topics.h"

namespace hair::python {

namespace {

// A read-only array of one number a strand.
py::array perStrand(const DetailPtr& detail, const std::vector<float>& values) {
  return arrayOver(values.data(), {static_cast<py::ssize_t>(values.size())}, capsuleOf(detail));
}

void bindDetail(py::module_& m) {
  py::class_<GroomDetail, DetailPtr>(
      m, "GroomDetail",
      "What the levels of a groom are made of, measured once; simulations of it may share it.")
      .def(py::init([](const GroomPtr& groom) {
             if (!groom) throw py::type_error("groom: None, but a Groom is wanted");
             return withoutLock([&] { return std::make_shared<GroomDetail>(*groom); });
           }),
           py::arg("groom").none(false), "Reads each strand at rest once.")
      .def_property_readonly(
          "rank", [](const DetailPtr& d) { return perStrand(d, d->rank); },
          "(S,) float32, [0, 1): strands of a lower rank stay longer; a read-only view.")
      .def_property_readonly(
          "length", [](const DetailPtr& d) { return perStrand(d, d->length); },
          "(S,) float32, metres at rest; a read-only view.")
      .def_property_readonly("strand_count", &GroomDetail::strandCount, "S.")
      .def("deviation", &GroomDetail::deviation, py::arg("points"),
           "How far strands are from those of that share of their segments, metres, root of the "
           "mean square.")
      .def("__repr__", [](const GroomDetail& d) {
        return text("<GroomDetail: ", d.strandCount(), " strands>");
      });
}

}  // namespace

void bindLevels(py::module_& m) {
  Fields<LevelOfDetail>(m, "LevelOfDetail");
  Fields<DetailSettings>(m, "DetailSettings");
  bindDetail(m);
  m.def("head_pixels", &headPixels, py::arg("distance"), py::arg("field_of_view"),
        py::arg("picture_height"),
        "How high a head is, chin to crown, in a picture so many pixels high that sees the angle "
        "field_of_view (radians, bottom to top) from distance metres.");
  m.def("level_for", &levelFor, py::arg("detail").none(false), py::arg("pixels"),
        py::arg("importance") = 1.0f, py::arg("settings").none(false) = DetailSettings{},
        R"(The LevelOfDetail at which hair on a head so many pixels high looks as all of it does.

importance, (0, 1]: a head of importance 0.5 is drawn as one half as large.)");
  m.def(
      "groom_at",
      [](const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level) {
        return withoutLock([&] { return std::make_shared<Groom>(groomAt(groom, detail, level)); });
      },
      py::arg("groom").none(false), py::arg("detail").none(false), py::arg("level").none(false),
      "A Groom that has no more than the level draws: less memory, for a crowd or a file.");
}

}  // namespace hair::python

// Lights, and the settings that have tables of fields in the library.
#include <pybind11/operators.h>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/simulation/frame.h>
#include <libhair/wisps/bind.h>

#include "fields.h"
#include "topics.h"

namespace hair::python {

namespace {

void bindLight(py::module_& m) {
  py::class_<Light>(m, "Light",
                    "A light: what casts shadows and what shading is told. It does not change.")
      .def_static(
          "parallel",
          [](glm::vec3 direction, glm::vec3 colour) {
            makeLightSpace(direction);  // throws where it is no direction
            return Light::parallel(direction, colour);
          },
          py::arg("direction"), py::arg("colour") = glm::vec3(1),
          "At infinity, as the sun. direction: the way light travels. colour: linear RGB.")
      .def_static(
          "point", &Light::point, py::arg("position"), py::arg("colour") = glm::vec3(1),
          "At a point (metres), as a lamp. colour: linear RGB of what arrives at the pivot.")
      .def_readonly("kind", &Light::kind, "\"parallel\" or \"point\".")
      .def_readonly("direction", &Light::direction, "Of parallel light, the way it travels.")
      .def_readonly("position", &Light::position, "Of a light at a point, metres.")
      .def_readonly("colour", &Light::colour, "Linear RGB.")
      .def(
          "__eq__", [](const Light& a, const Light& b) { return a == b; }, py::is_operator(),
          py::arg("other"), "The same in every number.")
      .def(py::pickle(
          [](const Light& l) { return py::make_tuple(l.kind, l.direction, l.position, l.colour); },
          [](const py::tuple& state) {
            Light light;
            light.kind = state[0].cast<Light::Kind>();
            light.direction = state[1].cast<glm::vec3>();
            light.position = state[2].cast<glm::vec3>();
            light.colour = state[3].cast<glm::vec3>();
            return light;
          }))
      .def("__repr__", [](const Light& l) {
        const bool parallel = l.kind == Light::Kind::Parallel;
        const glm::vec3 v = parallel ? l.direction : l.position;
        return text("Light.", parallel ? "parallel" : "point", "((", v.x, ", ", v.y, ", ", v.z,
                    "), (", l.colour.x, ", ", l.colour.y, ", ", l.colour.z, "))");
      });
}

// The lights of FrameSettings are a tuple: what is changed in a list that was read would be lost.
void bindFrameSettings(py::module_& m) {
  Fields<FrameSettings>(m, "FrameSettings")
      .property(
          "lights", [](const FrameSettings& s) { return py::tuple(py::cast(s.lights)); },
          [](FrameSettings& s, std::vector<Light> lights) { s.lights = std::move(lights); });
}

}  // namespace

void bindSettings(py::module_& m) {
  bindLight(m);
  Fields<GuideSettings>(m, "GuideSettings");
  Fields<RepulsionSettings>(m, "RepulsionSettings");
  Fields<Wind>(m, "Wind");
  Fields<WispSettings>(m, "WispSettings");
  Fields<DensityGridSettings>(m, "DensityGridSettings");
  Fields<DensityMapSettings>(m, "DensityMapSettings");
  Fields<ShadowMapSettings>(m, "ShadowMapSettings");
  Fields<OpacityMapSettings>(m, "OpacityMapSettings");
  Fields<DeepOpacityMapSettings>(m, "DeepOpacityMapSettings");
  Fields<DensityClusteringSettings>(m, "DensityClusteringSettings");
  Fields<DeepShadowMapSettings>(m, "DeepShadowMapSettings");
  Fields<PilotSettings>(m, "PilotSettings");
  Fields<KajiyaKaySettings>(m, "KajiyaKaySettings")
      .type()
      .def_static("plain", &KajiyaKaySettings::plain,
                  "The model of the paper alone: one highlight, unmoved, all strands alike.");
  bindFrameSettings(m);
  Fields<Fibre>(m, "Fibre");
  Fields<BindSettings>(m, "BindSettings");
  Fields<Parting>(m, "Parting");
  Fields<StyleSettings>(m, "StyleSettings");
}

}  // namespace hair::python

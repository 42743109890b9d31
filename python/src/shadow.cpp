// Shadows on strands: in one call, by any method, or pass by pass on a density map.
#include "shadow.h"

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/methods/shadow_method.h>
#include <libhair/wisps/bind.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

LightSpace lightSpaceFor(const Light& light, const std::optional<glm::vec3>& pivot,
                         StrandView strands) {
  if (pivot) return lightSpaceOf(light, *pivot);
  const bool none = strands.points.empty();
  return lightSpaceOf(light, none ? glm::vec3(0) : bounds(strands.points).centre());
}

Fibre fibreFor(const std::optional<Fibre>& fibre, StrandView strands) {
  if (fibre) return *fibre;
  Fibre shared;
  shared.hairsPerStrand = hairsEach(strands.strandCount());
  return shared;
}

namespace {

// Points to look at, or the strands' own (None).
struct Places {
  py::object given;
  py::array points;

  Places(const py::object& at, const Strands& strands)
      : given(at), points(at.is_none() ? strands.points : requirePoints(at, "at")) {}
  Shape shape() const { return {points.shape(0)}; }
};

// Finite, or a look-up leaves the map.
std::span<const glm::vec3> checkedPoints(const py::array& points, std::string_view name) {
  const auto items = pointsOf(points);
  for (std::size_t i = 0; i < items.size(); ++i)
    for (int c = 0; c < 3; ++c)
      require(std::abs(items[i][c]) < 1e8f, name, ": point ", i,
              " is not finite, or beyond 1e8 m (check the scale)");
  return items;
}

py::array shadow(const Strands& strands, const Light& light, float footprint,
                 const std::optional<Fibre>& fibre, const std::optional<ShadowSettings>& method,
                 const std::optional<glm::vec3>& pivot, const py::object& at,
                 const py::object& out) {
  const StrandView view = strands.view();
  const Places places(at, strands);
  const auto points = checkedPoints(places.points, "at");
  const py::array result = outputOf<float>(out, places.shape());
  const auto to = spanOf<float, float>(result);
  withoutLock([&] {
    require(std::isfinite(footprint) && footprint > 0, "shadow: footprint: ", footprint,
            " m; shadows are averaged over a disc of that radius, 3e-3 say");
    const LightSpace space = lightSpaceFor(light, pivot, view);
    const auto made = makeShadowMethod(
        method ? *method : ShadowSettings(automaticMapSettings(view, space, footprint)));
    made->build(view, fibreFor(fibre, view), space);
    if (at.is_none())
      made->sampleStrands(view, to);
    else
      made->sample(points, to);
  });
  return result;
}

/// A ShadowMethod that knows its settings.
class Method {
 public:
  explicit Method(const ShadowSettings& settings)
      : settings_(settings), method_(makeShadowMethod(settings)) {}

  void build(const Strands& strands, const Light& light, const std::optional<Fibre>& fibre,
             const std::optional<glm::vec3>& pivot) {
    const Busy busy(busy_, "shadow method");
    const StrandView view = strands.view();
    withoutLock(
        [&] { method_->build(view, fibreFor(fibre, view), lightSpaceFor(light, pivot, view)); });
    built_ = true;
  }
  py::array sample(const py::object& points, const py::object& out) {
    const Busy busy(busy_, "shadow method");
    requireBuilt();
    const py::array in = requirePoints(points, "points");
    const auto from = checkedPoints(in, "points");
    const py::array result = outputOf<float>(out, {in.shape(0)});
    const auto to = spanOf<float, float>(result);
    withoutLock([&] { method_->sample(from, to); });
    return result;
  }
  py::array sampleStrands(const Strands& strands, const py::object& out) {
    const Busy busy(busy_, "shadow method");
    requireBuilt();
    const StrandView view = strands.view();
    const py::array result = outputOf<float>(out, {strands.points.shape(0)});
    const auto to = spanOf<float, float>(result);
    withoutLock([&] { method_->sampleStrands(view, to); });
    return result;
  }
  const ShadowSettings& settings() const { return settings_; }
  std::size_t bytes() const { return built_ ? method_->bytes() : 0; }
  std::string name() const { return methodName(settings_); }
  std::string text() const { return settingsText(settings_); }

 private:
  void requireBuilt() const {
    require(built_, "shadow method: nothing was built yet; call build(strands, light)");
  }
  ShadowSettings settings_;
  std::unique_ptr<ShadowMethod> method_;
  bool built_ = false, busy_ = false;
};

void bindMethod(py::module_& m) {
  py::class_<Method>(m, "ShadowMethod",
                     R"(One way to shadow hair: build for strands and a light, then look up.

A second build reuses the memory of the first.)")
      .def(py::init<const ShadowSettings&>(), py::arg("settings"),
           "Settings of any method; Error where they are out of range.")
      .def("build", &Method::build, py::arg("strands"), py::arg("light"),
           py::arg("fibre") = py::none(), py::kw_only(), py::arg("pivot") = py::none(),
           "For these strands under this light. fibre: as in shadow. pivot: what a light at a "
           "point looks at, metres; "
           "None: the middle of the hair.")
      .def("sample", &Method::sample, py::arg("points"), py::arg("out") = py::none(),
           "Transmittance at points (N, 3) float32: (N,) float32, [0, 1]; in `out` if given.")
      .def("sample_strands", &Method::sampleStrands, py::arg("strands"),
           py::arg("out") = py::none(),
           "At all points of the strands it was built for, without a strand's own shadow where the "
           "method knows how: (N,) float32.")
      .def_property_readonly("settings", &Method::settings, "What it was made with; a copy.")
      .def_property_readonly("name", &Method::name, "\"density map\", \"deep opacity map\" ...")
      .def_property_readonly("bytes", &Method::bytes, "In memory between build and sample.")
      .def("__repr__", [](const Method& method) {
        return "<ShadowMethod: " + method.name() + " " + method.text() + ">";
      });
}

py::array shade(const Strands& strands, const std::vector<Light>& lights,
                const Appearance& appearance, const py::object& transmittance,
                const py::object& visibility, glm::vec3 eye, const std::optional<glm::vec3>& pivot,
                const py::object& out) {
  const StrandView view = strands.view();
  const py::ssize_t count = strands.points.shape(0);
  const Shape each = {static_cast<py::ssize_t>(lights.size()), count};
  const auto share = [&](const py::object& given, const char* name) -> std::span<const float> {
    if (given.is_none()) return {};
    return spanOf<const float, float>(requireArray(given, name, py::dtype::of<float>(), each));
  };
  Illumination illumination{lights, pivot.value_or(glm::vec3(0)), eye,
                            share(transmittance, "transmittance"), share(visibility, "visibility")};
  if (!pivot && count > 0) illumination.pivot = bounds(view.points).centre();
  py::array result = outputOf<float>(out, {count, 3});
  const auto to = spanOf<glm::vec3, float>(result);
  withoutLock([&] { hair::shade(view, illumination, appearance, to); });
  return result;
}

py::array encode(const py::object& radiance, const std::optional<Strands>& strands,
                 const py::object& weights, const py::object& out) {
  const py::array given = requirePoints(radiance, "radiance");
  const auto from = pointsOf(given);
  StrandView view;
  std::span<const float> shares;
  if (!weights.is_none()) {
    if (!strands) throw py::value_error("encode_srgb: weights are of strands, but strands is None");
    view = strands->view(0);
    if (view.pointCount() != from.size())
      throw py::value_error(text("strands: ", view.pointCount(), " points, but there are ",
                                 from.size(), " radiances"));
    shares =
        spanOf<const float, float>(requireArray(weights, "weights", py::dtype::of<float>(),
                                                {static_cast<py::ssize_t>(view.strandCount())}));
    for (std::size_t s = 0; s < shares.size(); ++s)
      require(shares[s] >= 0 && shares[s] <= 1, "weights: strand ", s, " has ", shares[s],
              ", which is not in 0 to 1");
  }
  py::array result = outputOf<std::uint8_t>(out, {given.shape(0), 4});
  if (reinterpret_cast<std::uintptr_t>(result.data()) % alignof(std::uint32_t) != 0)
    throw py::value_error("out: not aligned to 4 bytes");
  const auto to = spanOf<std::uint32_t, std::uint8_t>(result);
  withoutLock([&] { encodeSrgb(from, view.first, shares, to); });
  return result;
}

}  // namespace

void bindDensityMap(py::module_& m);

void bindShadows(py::module_& m) {
  bindMethod(m);
  bindDensityMap(m);
  m.def("shadow", &shadow, py::arg("strands"), py::arg("light"), py::arg("footprint") = 3e-3f,
        py::kw_only(), py::arg("fibre") = py::none(), py::arg("method") = py::none(),
        py::arg("pivot") = py::none(), py::arg("at") = py::none(), py::arg("out") = py::none(),
        R"(How much of the light gets to strands: transmittance, float32, 1 lit, 0 dark.

footprint: radius of the disc that shadows are averaged over, metres. fibre: what a strand stands
for; None: together they are the 100,000 hairs of a head; a strand that is one hair is
Fibre(hairs_per_strand=1). method: settings of any method; None:
the density map as measurement chose it for the footprint. pivot: what a light at a point looks at,
None: the middle of the hair. at: other points (M, 3) float32, a floor say; None: the strands' own,
without a strand's own shadow. Returns (N,) or (M,), `out` if given.)");
  m.def("shade", &shade, py::arg("strands"), py::arg("lights"),
        py::arg("appearance") = Appearance{}, py::kw_only(), py::arg("transmittance") = py::none(),
        py::arg("visibility") = py::none(), py::arg("eye") = glm::vec3(0, 0, 1),
        py::arg("pivot") = py::none(), py::arg("out") = py::none(),
        R"(Light that leaves all points towards the eye: linear RGB, (N, 3) float32.

It is 0 or more and has no upper end; encode_srgb makes bytes of it. appearance: KajiyaKaySettings.
transmittance, visibility: (lights, N) float32, what hair, and what all else, leaves of each light;
None: all. eye: where the picture is taken from, metres. pivot: where the colours of lights at points
are given, None: the middle of the hair. out: (N, 3) float32 to write to.)");
  m.def("encode_srgb", &encode, py::arg("radiance"), py::kw_only(), py::arg("strands") = py::none(),
        py::arg("weights") = py::none(), py::arg("out") = py::none(),
        R"(Linear radiance as displays show it: sRGB and opacity, (N, 4) uint8.

radiance: (N, 3) float32 linear RGB; what is above 1 is shown as 1. The opacity is 255; with strands
and weights, (S,) float32 in [0, 1], that of a strand is its weight. out: (N, 4) uint8 to write to.)");
}

}  // namespace hair::python

// The extension behind the package libhair.
#include <libhair/core/error.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

namespace {

template <class... Types>
py::dict choices() {
  py::dict all;
  (addChoices<Types>(all), ...);
  return all;
}

}  // namespace

}  // namespace hair::python

PYBIND11_MODULE(_libhair, m) {
  using namespace hair;
  using namespace hair::python;
  m.doc() = "Hair simulated and shadowed on the CPU: the extension behind the package libhair.";
  m.attr("__version__") = HAIR_VERSION;
  py::register_exception<Error>(m, "Error", PyExc_ValueError).attr("__doc__") =
      "A bad file or argument: what is wrong, where, and which knob to turn.";
  // For whoever writes stubs.
  m.attr("_choices") =
      choices<UpAxis, Style, LinkSolver, RepulsionKind, Deposit, Filter, Light::Kind, Extinction,
              LateralFilter, DeepOpacityMapSettings::Growth, DeepOpacityMapSettings::Beyond,
              DensityClusteringSettings::Start, CandidateSet>();
  bindGeometry(m);
  bindStrands(m);
  bindSettings(m);
  bindGrooms(m);
  bindLevels(m);
  bindMotion(m);
  bindSimulation(m);
  bindDensity(m);
  bindShadows(m);
  bindMeasure(m);
  bindThreads(m);
}

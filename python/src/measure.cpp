// What shadows should be, how far a method is from it, and which one keeps a budget.
#include <algorithm>
#include <cstddef>
#include <limits>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/measure/shadow/shadow_trial.h>

#include "choices.h"
#include "shadow.h"
#include "topics.h"

namespace hair::python {

namespace {

struct Points {
  std::vector<SamplePoint> items;
};
using PointsPtr = std::shared_ptr<Points>;

/// Truth, and where it was looked for.
struct TruthAt {
  PointsPtr points;
  Truth truth;
  float footprint;
};
using TruthPtr = std::shared_ptr<TruthAt>;

// A read-only array over one member of all points.
template <class Scalar>
py::array memberOf(const PointsPtr& points, std::size_t offset, py::ssize_t columns) {
  const auto count = static_cast<py::ssize_t>(points->items.size());
  const auto* data = reinterpret_cast<const std::byte*>(points->items.data()) + offset;
  Shape shape = {count}, strides = {sizeof(SamplePoint)};
  if (columns > 1) shape.push_back(columns), strides.push_back(sizeof(Scalar));
  py::array array(py::dtype::of<Scalar>(), shape, strides, data, capsuleOf(points));
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

TruthPtr exactTruth(const Strands& strands, const Light& light, const PointsPtr& points,
                    float footprint, std::uint32_t rays, std::uint32_t seed,
                    const std::optional<Fibre>& given, const std::optional<glm::vec3>& pivot) {
  const StrandView view = strands.view(2);
  const Fibre fibre = fibreFor(given, view);
  for (const SamplePoint& p : points->items)
    require(p.strand < view.strandCount() && p.point < view.pointCount(), "truth: strand ",
            p.strand, ", point ", p.point, " is not of these strands");
  const LightSpace space = lightSpaceFor(light, pivot, view);
  const TruthSettings settings{footprint, rays, seed};
  auto truth = std::make_shared<TruthAt>(TruthAt{points, {}, footprint});
  const auto tracer = withoutLock([&] { return makeGridTracer(view, fibre); });
  // In pieces, so that it can be stopped. A point's rays depend on the point alone: the bits are
  // those of one piece.
  const std::size_t piece = std::max<std::size_t>(1, (std::size_t{1} << 18) / std::max(rays, 1u));
  const std::span<const SamplePoint> all = points->items;
  for (std::size_t first = 0; first < all.size(); first += piece) {
    passInterrupts();
    const auto part = all.subspan(first, std::min(piece, all.size() - first));
    const Truth traced =
        withoutLock([&] { return exactTransmittance(*tracer, fibre, space, part, settings); });
    const auto add = [](const std::vector<float>& from, std::vector<float>& to) {
      to.insert(to.end(), from.begin(), from.end());
    };
    add(traced.transmittance, truth->truth.transmittance);
    add(traced.standardError, truth->truth.standardError);
  }
  return truth;
}

std::vector<ShadowTrial> trials(const std::vector<ShadowCandidate>& candidates,
                                const Strands& strands, const Light& light, const TruthAt& truth,
                                int repeats, const std::optional<Fibre>& fibre,
                                const std::optional<glm::vec3>& pivot, const py::object& onStep) {
  const StrandView view = strands.view(2);
  const LightSpace space = lightSpaceFor(light, pivot, view);
  const TrialScene scene{view, fibreFor(fibre, view), space, truth.points->items, truth.truth};
  const auto step = [&] {
    const py::gil_scoped_acquire lock;
    passInterrupts();
    if (!onStep.is_none()) onStep();
  };
  return withoutLock([&] { return runTrials(candidates, scene, repeats, step); });
}

MachineCosts calibrated(const py::object& strands, const Fibre& fibre, int repeats) {
  if (strands.is_none()) return withoutLock([] { return calibrate(); });
  const StrandView view = strands.cast<const Strands&>().view(2);
  return withoutLock([&] { return calibrate(view, fibre, repeats); });
}

void bindTruth(py::module_& m) {
  py::class_<Points, PointsPtr>(m, "SamplePoints",
                                "Strand points at which transmittance is wanted.")
      .def(
          "__len__", [](const Points& p) { return p.items.size(); }, "Points.")
      .def_property_readonly(
          "strand",
          [](const PointsPtr& p) {
            return memberOf<std::uint32_t>(p, offsetof(SamplePoint, strand), 1);
          },
          "(N,) uint32; a read-only view.")
      .def_property_readonly(
          "point",
          [](const PointsPtr& p) {
            return memberOf<std::uint32_t>(p, offsetof(SamplePoint, point), 1);
          },
          "(N,) uint32, rows of Strands.points; a read-only view.")
      .def_property_readonly(
          "position",
          [](const PointsPtr& p) { return memberOf<float>(p, offsetof(SamplePoint, position), 3); },
          "(N, 3) float32, metres; a read-only view.")
      .def("__repr__",
           [](const Points& p) { return text("<SamplePoints: ", p.items.size(), ">"); });
  m.def(
      "choose_points",
      [](const Strands& strands, std::size_t count, std::uint32_t seed) {
        const StrandView view = strands.view();
        return std::make_shared<Points>(Points{chooseSamplePoints(view, count, seed)});
      },
      py::arg("strands"), py::arg("count"), py::arg("seed") = TruthSettings{}.seed,
      "So many SamplePoints at random, each of its own strand as long as there are enough; no "
      "roots.");

  py::class_<TruthAt, TruthPtr>(m, "Truth", "Exact transmittance at some points of strands.")
      .def_readonly("points", &TruthAt::points, "SamplePoints.")
      .def_readonly("footprint", &TruthAt::footprint, "Metres.")
      .def_property_readonly(
          "transmittance",
          [](const TruthPtr& t) {
            const auto& values = t->truth.transmittance;
            return arrayOver(values.data(), {static_cast<py::ssize_t>(values.size())},
                             capsuleOf(t));
          },
          "(N,) float32, [0, 1]; a read-only view.")
      .def_property_readonly(
          "standard_error",
          [](const TruthPtr& t) {
            const auto& values = t->truth.standardError;
            return arrayOver(values.data(), {static_cast<py::ssize_t>(values.size())},
                             capsuleOf(t));
          },
          "(N,) float32; a read-only view.")
      .def("__repr__", [](const TruthAt& t) {
        return text("<Truth at ", t.truth.transmittance.size(), " points, footprint ",
                    1000 * t.footprint, " mm>");
      });
  m.def("truth", &exactTruth, py::arg("strands"), py::arg("light"), py::arg("points").none(false),
        py::arg("footprint") = TruthSettings{}.footprint, py::kw_only(),
        py::arg("rays") = TruthSettings{}.rays, py::arg("seed") = TruthSettings{}.seed,
        py::arg("fibre") = py::none(), py::arg("pivot") = py::none(),
        R"(Transmittance by rays through fibres of real width: slow, and right. Ctrl-C stops it.

points: SamplePoints of the strands. footprint: radius of the disc that is averaged over, metres.
rays: a point. A strand is a tube as wide as all the hairs of fibre that it stands for.)");
}

void bindErrors(py::module_& m) {
  using Figure = ErrorFigures::Figure;
  py::class_<Figure>(m, "Figure", "A measured number.")
      .def_readonly("value", &Figure::value, "The number.")
      .def_readonly("standard_error", &Figure::standardError, "Its standard error.")
      .def(
          "__float__", [](const Figure& f) { return f.value; }, "The number.")
      .def("__repr__", [](const Figure& f) { return text(f.value, " ± ", f.standardError); });
  py::class_<ErrorFigures>(m, "ErrorFigures", "How far transmittances are from the truth.")
      .def_readonly("mean_absolute", &ErrorFigures::meanAbsolute, "Figure.")
      .def_readonly("rms", &ErrorFigures::rms, "Figure: root of the mean square.")
      .def_readonly("percentile99", &ErrorFigures::percentile99, "Figure, of the absolute error.")
      .def_readonly("bias", &ErrorFigures::bias, "Figure: mean of measured - truth.")
      .def("__repr__", [](const ErrorFigures& e) {
        return text("<ErrorFigures: mean absolute ", e.meanAbsolute.value, ", rms ", e.rms.value,
                    ", bias ", e.bias.value, ">");
      });
  m.def(
      "error_figures",
      [](const py::object& measured, const TruthAt& truth) {
        const auto count = static_cast<py::ssize_t>(truth.truth.transmittance.size());
        const py::array in = requireArray(measured, "measured", py::dtype::of<float>(), {count});
        return errorFigures(spanOf<const float, float>(in), truth.truth);
      },
      py::arg("measured"), py::arg("truth"),
      "Of transmittances (N,) float32 at the truth's points: shadow(...)[truth.points.point].");
}

void bindTrials(py::module_& m) {
  py::class_<ShadowCandidate>(m, "Candidate", "One row of a table that compares ways to shadow.")
      .def(py::init([](const ShadowSettings& settings, std::string label) {
             ShadowCandidate c{methodName(settings), std::move(label), settings};
             if (c.label.empty()) c.label = c.method + " " + settingsText(settings);
             return c;
           }),
           py::arg("settings"), py::arg("label") = "", "label: \"\": method and settings in words.")
      .def_readonly("method", &ShadowCandidate::method, "\"density map\" ..., or \"auto\".")
      .def_readonly("label", &ShadowCandidate::label, "In words; differs within a list.")
      .def_readonly("settings", &ShadowCandidate::settings, "Of its method.")
      .def("__repr__", [](const ShadowCandidate& c) { return "<Candidate: " + c.label + ">"; });
  m.def(
      "candidates",
      [](const Strands& strands, const Light& light, float footprint, CandidateSet set,
         const std::optional<glm::vec3>& pivot) {
        const StrandView view = strands.view(2);
        return withoutLock([&] {
          return shadowCandidates(view, lightSpaceFor(light, pivot, view), footprint, set);
        });
      },
      py::arg("strands"), py::arg("light"), py::arg("footprint") = TruthSettings{}.footprint,
      py::arg("set") = CandidateSet::Quick, py::kw_only(), py::arg("pivot") = py::none(),
      "What is worth trying at this footprint (metres). set: \"quick\", each method once; "
      "\"all\".");

  py::class_<ShadowTrial, std::shared_ptr<ShadowTrial>>(
      m, "Trial", "What a way to shadow costs, and how far from the truth it is.")
      .def_readonly("candidate", &ShadowTrial::candidate, "Candidate.")
      .def_readonly("failure", &ShadowTrial::failure, "Why it cannot shadow this hair, or \"\".")
      .def_readonly("error", &ShadowTrial::error, "ErrorFigures.")
      .def_readonly("build_milliseconds", &ShadowTrial::buildMilliseconds, "Median.")
      .def_readonly("sample_milliseconds", &ShadowTrial::sampleMilliseconds,
                    "Median, at all points of the hair.")
      .def_property_readonly("milliseconds", &ShadowTrial::milliseconds, "Build and sample.")
      .def_readonly("bytes", &ShadowTrial::bytes, "In memory between the two.")
      .def_property_readonly(
          "transmittance",
          [](const std::shared_ptr<ShadowTrial>& t) {
            return arrayOver(t->transmittance.data(),
                             {static_cast<py::ssize_t>(t->transmittance.size())}, capsuleOf(t));
          },
          "At the truth's points, (N,) float32; a read-only view.")
      .def("__repr__", [](const ShadowTrial& t) {
        return t.failed() ? "<Trial: " + t.candidate.label + ": " + t.failure + ">"
                          : text("<Trial: ", t.candidate.label, ": error ",
                                 t.error.meanAbsolute.value, ", ", t.milliseconds(), " ms>");
      });
  m.def(
      "run_trials", &trials, py::arg("candidates"), py::arg("strands"), py::arg("light"),
      py::arg("truth"), py::arg("repeats") = 3, py::kw_only(), py::arg("fibre") = py::none(),
      py::arg("pivot") = py::none(), py::arg("on_step") = py::none(),
      "Tries every candidate so many times, in turns; a list of Trial. Ctrl-C stops it between two "
      "of them. on_step: called after each.");
  m.def(
      "trial_front", [](const std::vector<ShadowTrial>& list) { return trialFront(list); },
      py::arg("trials"), "Indices of trials that no other beats in both time and error.");
}

void bindChoice(py::module_& m) {
  py::class_<MachineCosts>(m, "MachineCosts", "How fast this machine is, as calibrate() found it.")
      .def(py::init([](const py::object& nanoseconds, int threads) {
             const py::array given = requireArray(
                 nanoseconds, "nanoseconds", py::dtype::of<double>(),
                 {static_cast<py::ssize_t>(kCostStages), static_cast<py::ssize_t>(kCostTerms)});
             MachineCosts costs;
             const auto rows = spanOf<const CostTerms, double>(given);
             std::copy(rows.begin(), rows.end(), costs.nanoseconds.begin());
             costs.threads = threads;
             return costs;
           }),
           py::arg("nanoseconds"), py::arg("threads"), "As it was kept: numpy.save, numpy.load.")
      .def_property_readonly(
          "nanoseconds",
          [](const MachineCosts& costs) {
            py::array_t<double> out({kCostStages, kCostTerms});
            std::copy_n(costs.nanoseconds[0].data(), kCostStages * kCostTerms, out.mutable_data());
            return out;
          },
          "(stages, terms) float64; a copy.")
      .def_readonly("threads", &MachineCosts::threads, "That it was measured with.")
      .def("__repr__", [](const MachineCosts& costs) {
        return text("<MachineCosts with ", costs.threads, " threads>");
      });
  m.def("calibrate", &calibrated, py::arg("strands") = py::none(), py::arg("fibre") = Fibre{},
        py::arg("repeats") = 3,
        "Times every stage of every method, some seconds, on strands (some thousand at least) or a "
        "built-in style. Keep what it returns.");

  py::class_<ShadowChoice>(m, "Choice", "Settings that keep a budget, and what they should do.")
      .def_property_readonly(
          "settings", [](const ShadowChoice& c) { return c.predicted.candidate.settings; },
          "Of the method; what shadow(method=...) takes.")
      .def_property_readonly(
          "label", [](const ShadowChoice& c) { return c.predicted.candidate.label; }, "In words.")
      .def_property_readonly(
          "predicted_milliseconds",
          [](const ShadowChoice& c) { return c.predicted.time.milliseconds(); },
          "Build, and sample at all points.")
      .def_property_readonly(
          "predicted_error",
          [](const ShadowChoice& c) {
            return ErrorFigures::Figure{c.predicted.error.meanAbsolute,
                                        c.predicted.error.standardError};
          },
          "Figure: mean absolute error of transmittance.")
      .def_readonly("reason", &ShadowChoice::reason, "What limits, and what it was chosen among.")
      .def_readonly("tried", &ShadowChoice::tried, "Candidates whose error was predicted.")
      .def("__repr__", [](const ShadowChoice& c) {
        return text("<Choice: ", c.predicted.candidate.label, ": ", c.reason, ">");
      });
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  m.def(
      "choose_shadow",
      [](const Strands& strands, const Light& light, const MachineCosts& machine, double maxError,
         double milliseconds, float footprint, const std::optional<Fibre>& fibre,
         const std::optional<glm::vec3>& pivot, const PilotSettings& pilot) {
        const StrandView view = strands.view(2);
        return withoutLock([&] {
          return chooseShadow(view, fibreFor(fibre, view), lightSpaceFor(light, pivot, view),
                              footprint, {maxError, milliseconds}, machine, pilot);
        });
      },
      py::arg("strands"), py::arg("light"), py::arg("machine"), py::kw_only(),
      py::arg("max_error") = kNoLimit, py::arg("milliseconds") = kNoLimit,
      py::arg("footprint") = TruthSettings{}.footprint, py::arg("fibre") = py::none(),
      py::arg("pivot") = py::none(), py::arg("pilot") = PilotSettings{},
      R"(The method and settings for this hair that keep a limit of errors, of time, or both.

max_error: mean absolute error of transmittance. milliseconds: build and sample at all points on
the machine. With a limit of errors the fastest, else the most accurate. Error where none keeps
them: it says what is nearest.)");
}

}  // namespace

void bindMeasure(py::module_& m) {
  bindTruth(m);
  bindErrors(m);
  bindTrials(m);
  bindChoice(m);
}

}  // namespace hair::python

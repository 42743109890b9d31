#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <span>

#include <apps/common/progress.h>
#include <apps/hair/commands.h>
#include <apps/hair/measure/check.h>
#include <apps/hair/measure/choice.h>
#include <apps/hair/measure/measure_report.h>
#include <apps/hair/measure/report_html.h>
#include <apps/hair/measure/tables.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/measure/shadow/shadow_trial.h>

namespace hair {

namespace {

constexpr std::size_t kRaySteps = 240;
constexpr std::size_t kTruthFlickerPoints = 128;  // of the samples; the truth is slow
constexpr glm::vec3 kUsualLight{0.45f, -0.8f, -0.4f};

std::vector<ShadowCandidate> candidatesFor(const MeasureReport& report, const LightSpace& light,
                                           float footprint, const std::set<std::string>& wanted) {
  const CandidateSet set =
      report.options.methods == "quick" ? CandidateSet::Quick : CandidateSet::All;
  std::vector<ShadowCandidate> list = shadowCandidates(report.hair.strands, light, footprint, set);
  std::erase_if(list, [&](const ShadowCandidate& candidate) {
    return !wanted.empty() && !wanted.contains(candidate.method);
  });
  return list;
}

std::vector<MeasuredLight> lightsOf(const MeasureOptions& options, const MeasuredHair& hair) {
  std::vector<MeasuredLight> lights;
  for (const glm::vec3 way : options.lights) lights.push_back({false, way, makeLightSpace(way)});
  const glm::vec3 middle = bounds(hair.strands.points).centre();
  for (const glm::vec3 lamp : options.lamps)
    lights.push_back({true, lamp, makePointLightSpace(lamp, middle)});
  if (lights.empty()) lights.push_back({false, kUsualLight, makeLightSpace(kUsualLight)});
  return lights;
}

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const std::size_t colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown CPU";
}

void measureFlicker(const MeasureReport& report, const FibreTracer& tracer,
                    const TruthSettings& truth, MeasuredCase& measured) {
  const Fibre& fibre = report.hair.fibre;
  FlickerSettings turning;
  turning.steps = report.options.flickerSteps;
  const std::vector<LightSpace> lights = turningLights(measured.light.space, turning);
  Progress progress("flicker", static_cast<std::int64_t>(measured.best.size()) + 1);
  for (const std::size_t t : measured.best) {
    measured.flicker.push_back(flickerOf(measured.trials[t].candidate.settings, report.hair.strands,
                                         fibre, lights, report.points));
    progress.step();
  }
  std::vector<SamplePoint> few;
  const std::size_t count = std::min(report.points.size(), kTruthFlickerPoints);
  for (std::size_t i = 0; i < count; ++i)
    few.push_back(report.points[i * report.points.size() / count]);
  measured.truthFlicker = flickerOf(tracer, fibre, lights, few, truth);
  progress.step();
}

// In pieces, so that one sees how far it is. A point's rays depend on the point alone: the bits are
// those of one piece.
Truth traceTruth(const MeasureReport& report, const FibreTracer& tracer, const LightSpace& light,
                 const TruthSettings& settings) {
  const std::span<const SamplePoint> points = report.points;
  const std::size_t piece = std::max<std::size_t>(1, (std::size_t{1} << 20) / settings.rays);
  Truth truth;
  Progress progress("truth", static_cast<std::int64_t>(points.size()));
  for (std::size_t first = 0; first < points.size(); first += piece) {
    const auto part = points.subspan(first, std::min(piece, points.size() - first));
    const Truth traced = exactTransmittance(tracer, report.hair.fibre, light, part, settings);
    truth.transmittance.insert(truth.transmittance.end(), traced.transmittance.begin(),
                               traced.transmittance.end());
    truth.standardError.insert(truth.standardError.end(), traced.standardError.begin(),
                               traced.standardError.end());
    progress.step(static_cast<std::int64_t>(part.size()));
  }
  return truth;
}

MeasuredCase measureCase(const MeasureReport& report, const FibreTracer& tracer,
                         const MeasuredLight& light, float footprint,
                         const std::set<std::string>& wanted,
                         const std::optional<MachineCosts>& machine) {
  const MeasureOptions& options = report.options;
  const MeasuredHair& hair = report.hair;
  MeasuredCase measured;
  measured.light = light;
  measured.footprint = footprint;
  std::vector<ShadowCandidate> candidates = candidatesFor(report, light.space, footprint, wanted);
  if (machine)
    measured.choice =
        addChoice(report, light.space, footprint, *budgetOf(options), *machine, candidates);
  const TruthSettings truth{footprint, options.rays, options.seed};
  std::cerr << light.name() << ", footprint " << footprint << " m\n";
  measured.truth = traceTruth(report, tracer, light.space, truth);

  if (!options.html.empty()) {
    const glm::vec3 thick =
        thickOfHair(tracer, hair.strands, light.space, report.points, footprint);
    measured.ray =
        makeVisibilityRay(tracer, hair.strands, hair.fibre, light.space, thick, kRaySteps, truth);
  }
  {
    const TrialScene scene{hair.strands,  hair.fibre,     light.space,
                           report.points, measured.truth, measured.ray.points};
    Progress progress("methods", static_cast<std::int64_t>(candidates.size()) * options.repeats);
    measured.trials =
        runTrials(candidates, scene, options.repeats, [&progress] { progress.step(); });
  }
  for (const ShadowTrial& trial : measured.trials)
    if (trial.failed()) std::cerr << trial.candidate.label << ": " << trial.failure << '\n';
  measured.front = trialFront(measured.trials);
  measured.best = bestOfEachMethod(measured.trials);
  require(!measured.best.empty(), light.name(), ", footprint ", footprint,
          " m: no method can shadow this hair: ", measured.trials.front().failure);
  if (options.flickerSteps > 0) measureFlicker(report, tracer, truth, measured);
  return measured;
}

}  // namespace

std::string MeasuredLight::name() const {
  return text(atPoint ? "point " : "light ", given.x, ',', given.y, ',', given.z);
}

void runMeasure(const MeasureOptions& options) {
  checkOptions(options);
  const std::set<std::string> wanted = methodsWanted(options.methods);
  const bool chooses = budgetOf(options).has_value();
  const ThreadLimit limit(options.threads);
  MeasureReport report;
  report.options = options;
  report.version = HAIR_VERSION;
  report.cpu = cpuName();
  report.threads = threadCount();
  report.hair = measuredHair(options);
  for (const std::string& note : report.hair.notes) std::cerr << note << '\n';
  const std::vector<MeasuredLight> lights = lightsOf(options, report.hair);
  report.points = chooseSamplePoints(report.hair.strands, options.samples, options.seed);
  require(!report.points.empty(), report.hair.name, ": no points but roots to measure at");
  const std::unique_ptr<FibreTracer> tracer =
      makeGridTracer(report.hair.strands, report.hair.fibre);

  std::optional<MachineCosts> machine;
  if (chooses) {
    std::cerr << "calibrating costs\n";
    machine = calibrate();
  }

  const Fibre& fibre = report.hair.fibre;
  std::cout << report.hair.name << ": " << report.hair.strands.strandCount() << " strands, "
            << report.hair.strands.pointCount() << " points, width "
            << fibre.width * fibre.hairsPerStrand << " m, opacity " << fibre.opacity << "\n"
            << report.cpu << ", " << report.threads << " threads, medians of " << options.repeats
            << " runs; seed " << options.seed << ", " << options.rays << " rays a sample\n\n";
  for (const MeasuredLight& light : lights)
    for (const float footprint : options.footprints) {
      report.cases.push_back(measureCase(report, *tracer, light, footprint, wanted, machine));
      printTable(report, report.cases.back(), std::cout);
      if (report.cases.back().choice)
        printChoice(*report.cases.back().choice, report.cases.back().trials, std::cout);
    }
  const auto write = [&](const std::filesystem::path& file, const auto& body) {
    if (file.empty()) return;
    writeAtomically(file, body);
    std::cout << file.string() << " written\n";
  };
  write(options.csv, [&](std::ostream& out) { writeCsv(report, out); });
  write(options.dump, [&](std::ostream& out) { writeDump(report, report.cases.front(), out); });
  write(options.html, [&](std::ostream& out) { writeHtml(report, out); });
}

}  // namespace hair

#include <libhair/measure/shadow/shadow_trial.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/pareto.h>

namespace hair {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct Times {
  std::vector<double> build, sample;
};

// One round of one candidate. `all`: scratch, transmittance at all points of the hair.
void runOnce(const TrialScene& scene, ShadowTrial& trial, Times& times, std::vector<float>& all) {
  const std::unique_ptr<ShadowMethod> method = makeShadowMethod(trial.candidate.settings);
  method->build(scene.strands, scene.fibre, scene.light);

  Clock::time_point start = Clock::now();
  method->build(scene.strands, scene.fibre, scene.light);
  times.build.push_back(millisecondsSince(start));

  start = Clock::now();
  method->sampleStrands(scene.strands, all);
  times.sample.push_back(millisecondsSince(start));

  if (times.build.size() > 1) return;  // the rest is the same in every round
  trial.bytes = method->bytes();
  trial.transmittance.resize(scene.points.size());
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    trial.transmittance[i] = all[scene.points[i].point];
  trial.error = errorFigures(trial.transmittance, scene.truth);
  trial.probes.resize(scene.probes.size());
  method->sample(scene.probes, trial.probes);
}

void checkScene(const TrialScene& scene) {
  require(scene.points.size() == scene.truth.transmittance.size(),
          "shadow trial: ", scene.points.size(), " points but the truth at ",
          scene.truth.transmittance.size());
  for (const SamplePoint& point : scene.points)
    require(point.point < scene.strands.pointCount(), "shadow trial: sample point ", point.point,
            " of ", scene.strands.pointCount(), " points");
}

}  // namespace

std::vector<ShadowTrial> runTrials(std::span<const ShadowCandidate> candidates,
                                   const TrialScene& scene, int repeats,
                                   const std::function<void()>& done) {
  require(repeats >= 1, "shadow trial: ", repeats, " repeats; set 1 or more");
  checkScene(scene);
  std::vector<ShadowTrial> trials(candidates.size());
  for (std::size_t c = 0; c < candidates.size(); ++c) trials[c].candidate = candidates[c];
  std::vector<Times> times(candidates.size());
  std::vector<float> all(scene.strands.pointCount(), 1.0f);
  for (int round = 0; round < repeats; ++round)
    for (std::size_t step = 0; step < candidates.size(); ++step) {
      const std::size_t c = round % 2 == 0 ? step : candidates.size() - 1 - step;
      try {
        if (!trials[c].failed()) runOnce(scene, trials[c], times[c], all);
      } catch (const Error& e) {
        trials[c].failure = e.what();
      }
      if (done) done();
    }
  const double points = std::max(static_cast<double>(scene.strands.pointCount()), 1.0);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    trials[c].buildMilliseconds = median(times[c].build);
    trials[c].sampleMilliseconds = median(times[c].sample);
    trials[c].sampleNanoseconds = trials[c].sampleMilliseconds * 1e6 / points;
  }
  return trials;
}

std::vector<std::size_t> bestOfEachMethod(std::span<const ShadowTrial> trials) {
  std::vector<std::size_t> best;
  std::map<std::string, std::size_t> place;  // of a method in `best`
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].failed()) continue;
    const auto [entry, isNew] = place.try_emplace(trials[t].candidate.method, best.size());
    if (isNew)
      best.push_back(t);
    else if (trials[t].error.meanAbsolute.value <
             trials[best[entry->second]].error.meanAbsolute.value)
      best[entry->second] = t;
  }
  return best;
}

std::vector<std::size_t> trialFront(std::span<const ShadowTrial> trials) {
  std::vector<double> time, error;
  for (const ShadowTrial& trial : trials) {
    time.push_back(trial.failed() ? std::numeric_limits<double>::quiet_NaN()
                                  : trial.milliseconds());
    error.push_back(trial.error.meanAbsolute.value);
  }
  return paretoFront(time, error);
}

}  // namespace hair

// chooseShadow in short. Times are cheap to predict (a formula), errors are not (a build and a
// comparison with traced rays), so candidates are taken by rising time:
//
//      error |  x                         1. Predict all times, and sort by them.
//            |     x                      2. Predict errors from the fastest on, until
//            |           x                   - the time limit, or
//   maxError |- - - - - - - o - - - .        - the first error within maxError: all that
//            |                      :          follow are slower.
//            '----------------------'--   3. Choose the fastest within maxError; without
//                     time        limit      maxError, the most accurate.
//
// A prediction is within maxError if it still is with one standard error added.
#include <libhair/measure/shadow/choose.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/cost_model.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/shadow/density_map.h>

namespace hair {

namespace {

void checkBudget(const ShadowBudget& budget) {
  require(budget.maxError > 0, "max error: ", budget.maxError, " is not positive");
  require(budget.milliseconds > 0, "time budget: ", budget.milliseconds, " ms is not positive");
  require(std::isfinite(budget.maxError) || std::isfinite(budget.milliseconds),
          "choice of shadows: no limit to choose by; set a max error or a time budget");
}

// Settings that only reproduce their papers.
bool isForItsPaper(const ShadowSettings& settings) {
  return std::visit(
      [](const auto& s) {
        using Settings = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<Settings, DensityMapSettings>) {
          return s.filter == Filter::None || s.filter == Filter::Paper;
        } else if constexpr (std::is_same_v<Settings, ShadowMapSettings>) {
          return false;
        } else {
          return s.extinction == Extinction::Published;
        }
      },
      settings);
}

// Deep shadow maps without compression, whose visibility functions have a node for every fragment:
// costs are not fitted for these, and a little tolerance is never worse.
bool isUncompressed(const ShadowSettings& settings) {
  const auto* const deep = std::get_if<DeepShadowMapSettings>(&settings);
  return deep != nullptr && deep->tolerance == 0;
}

std::string describe(const PredictedShadow& shadow) {
  return text(shadow.candidate.label, " (error ", shadow.error.meanAbsolute, " +- ",
              shadow.error.standardError, ", ", shadow.time.milliseconds(), " ms)");
}

// Name the nearest candidate, and the limit that would admit it.
[[noreturn]] void failOnTime(const PredictedShadow& fastest, double limit) {
  throw Error(text("time budget ", limit, " ms: nothing is that fast here; the nearest is ",
                   fastest.candidate.label, "; raise the time budget to ",
                   fastest.time.milliseconds(), " ms, or take fewer strands or points"));
}

[[noreturn]] void failOnError(const PredictedShadow& nearest, const ShadowBudget& budget) {
  const bool timed = std::isfinite(budget.milliseconds);
  throw Error(text("max error ", budget.maxError, ": nothing ",
                   timed ? text("within ", budget.milliseconds, " ms ") : std::string(),
                   "is that accurate here; the nearest is ", describe(nearest),
                   "; raise the max error to ", nearest.cautiousError(),
                   timed ? ", or raise the time budget" : ", or average over a larger footprint"));
}

bool faster(const PredictedShadow& a, const PredictedShadow& b) {
  return a.time.milliseconds() < b.time.milliseconds();
}

// A density map over the extent and a margin of three cells on each side.
DensityMapSettings mapOf(float cell, float extent, Filter filter, float footprint) {
  constexpr int kMostCells = 512;
  DensityMapSettings s = settingsForFootprint(cell, extent + 6 * cell, kMostCells);
  s.filter = filter;
  if (filter == Filter::Footprint) s.footprint = footprint;
  return s;
}

}  // namespace

std::vector<ShadowCandidate> choiceCandidates(StrandView strands, const LightSpace& light,
                                              float footprint) {
  // Take the candidates of all methods, but replace density maps with Columns by a finer range.
  std::vector<ShadowCandidate> list =
      shadowCandidates(strands, light, footprint, CandidateSet::All);
  std::erase_if(list, [](const ShadowCandidate& c) {
    const auto* const map = std::get_if<DensityMapSettings>(&c.settings);
    return isForItsPaper(c.settings) || isUncompressed(c.settings) ||
           (map != nullptr && map->deposit == Deposit::Columns);
  });
  // Add density maps with cells a quarter of an octave apart.
  const float extent = std::max(extentSeen(strands, light), footprint);
  const auto add = [&](int quarter, Filter filter) {
    const float part = std::exp2(0.25f * static_cast<float>(quarter));
    const ShadowSettings settings = mapOf(part * footprint, extent, filter, footprint);
    const std::string label = methodName(settings) + ' ' + settingsText(settings);
    // Skip duplicates: cells too small for the largest map are enlarged to the same size.
    const bool known = std::any_of(list.begin(), list.end(),
                                   [&](const ShadowCandidate& c) { return c.label == label; });
    if (!known) list.push_back({methodName(settings), label, settings});
  };
  for (int quarter = -6; quarter <= 0; ++quarter) add(quarter, Filter::Footprint);
  for (int quarter = -2; quarter <= 8; ++quarter) add(quarter, Filter::Centred);
  return list;
}

ShadowChoice chooseAmong(const std::vector<PredictedShadow>& predictions,
                         const ShadowBudget& budget) {
  // Fail if even the fastest exceeds the time limit.
  checkBudget(budget);
  require(!predictions.empty(), "choice of shadows: nothing to choose among");
  const auto fastest = std::min_element(predictions.begin(), predictions.end(), faster);
  if (fastest->time.milliseconds() > budget.milliseconds) failOnTime(*fastest, budget.milliseconds);
  // Find the best within the limits, and the most accurate within that of time.
  const bool byError = std::isfinite(budget.maxError);
  const PredictedShadow* chosen = nullptr;
  const PredictedShadow* nearest = nullptr;
  for (const PredictedShadow& p : predictions) {
    if (p.time.milliseconds() > budget.milliseconds) continue;
    if (!nearest || p.cautiousError() < nearest->cautiousError()) nearest = &p;
    if (byError && p.cautiousError() > budget.maxError) continue;
    // Compare by time under a limit of the error, else by error; break ties by the other.
    const bool better =
        !chosen ||
        (byError ? std::tuple(p.time.milliseconds(), p.error.meanAbsolute) <
                       std::tuple(chosen->time.milliseconds(), chosen->error.meanAbsolute)
                 : std::tuple(p.error.meanAbsolute, p.time.milliseconds()) <
                       std::tuple(chosen->error.meanAbsolute, chosen->time.milliseconds()));
    if (better) chosen = &p;
  }
  // Say why.
  if (!chosen) failOnError(*nearest, budget);
  ShadowChoice choice{*chosen, {}, predictions.size()};
  choice.reason = byError ? text("the fastest with an error, and a standard error of it, within ",
                                 budget.maxError)
                          : text("the most accurate within ", budget.milliseconds, " ms");
  if (byError && std::isfinite(budget.milliseconds))
    choice.reason += text(" and ", budget.milliseconds, " ms");
  return choice;
}

ShadowChoice chooseShadow(StrandView strands, const Fibre& fibre, const LightSpace& light,
                          float footprint, const ShadowBudget& budget, const MachineCosts& machine,
                          const PilotSettings& settings) {
  // Predict the times of all candidates, and sort by them.
  checkBudget(budget);
  const HairFeatures hair = hairFeatures(strands, light);
  std::vector<PredictedShadow> all;
  for (ShadowCandidate& candidate : choiceCandidates(strands, light, footprint)) {
    const PredictedTime time = predictTime(machine, hair, candidate.settings);
    all.push_back({std::move(candidate), time, {}});
  }
  std::stable_sort(all.begin(), all.end(), faster);
  if (all.front().time.milliseconds() > budget.milliseconds)
    failOnTime(all.front(), budget.milliseconds);
  // Predict errors, fastest first; leave out candidates that cannot shadow this hair.
  ErrorPilot pilot(strands, fibre, light, footprint, settings);
  std::vector<PredictedShadow> predicted;
  std::string failure;
  for (PredictedShadow& p : all) {
    if (p.time.milliseconds() > budget.milliseconds) break;
    try {
      p.error = pilot.predict(p.candidate.settings);
    } catch (const Error& e) {
      failure = text(p.candidate.label, ": ", e.what());
      continue;
    }
    predicted.push_back(std::move(p));
    // Stop at the first that meets the limit of the error: all others are slower.
    if (std::isfinite(budget.maxError) && predicted.back().cautiousError() <= budget.maxError)
      break;
  }
  // Choose, and add the size of the pilot to the reason.
  require(!predicted.empty(), "choice of shadows: nothing can shadow this hair; ", failure);
  ShadowChoice choice = chooseAmong(predicted, budget);
  choice.reason +=
      text("; error predicted from ", pilot.pointCount(), " points x ", pilot.rays(), " rays");
  return choice;
}

}  // namespace hair

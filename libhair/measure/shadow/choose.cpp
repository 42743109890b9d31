#include <libhair/measure/shadow/choose.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <libhair/core/error.h>
#include <libhair/shadow/automatic.h>

namespace hair {

namespace {

void checkBudget(const ShadowBudget& budget) {
  require(budget.maxError > 0, "max error: ", budget.maxError, " is not positive");
  require(budget.milliseconds > 0, "time budget: ", budget.milliseconds, " ms is not positive");
  require(std::isfinite(budget.maxError) || std::isfinite(budget.milliseconds),
          "choice of shadows: no limit to choose by; set a max error or a time budget");
}

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

// Compressed by no tolerance a visibility function is as long as its fragments are many: nothing
// that costs are fitted for, and never better than the same with a little.
bool isUncompressed(const ShadowSettings& settings) {
  const auto* const deep = std::get_if<DeepShadowMapSettings>(&settings);
  return deep != nullptr && deep->tolerance == 0;
}

std::string describe(const PredictedShadow& shadow) {
  return text(shadow.candidate.label, " (error ", shadow.error.meanAbsolute, " +- ",
              shadow.error.standardError, ", ", shadow.time.milliseconds(), " ms)");
}

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
  std::vector<ShadowCandidate> list =
      shadowCandidates(strands, light, footprint, CandidateSet::All);
  std::erase_if(list, [](const ShadowCandidate& c) {
    // A range of density maps of the same kind follows.
    const auto* const map = std::get_if<DensityMapSettings>(&c.settings);
    return isForItsPaper(c.settings) || isUncompressed(c.settings) ||
           (map != nullptr && map->deposit == Deposit::Columns);
  });
  const float extent = std::max(extentSeen(strands, light), footprint);
  const auto add = [&](int quarter, Filter filter) {
    // Cells a quarter of an octave apart.
    const float part = std::exp2(0.25f * static_cast<float>(quarter));
    const ShadowSettings settings = mapOf(part * footprint, extent, filter, footprint);
    const std::string label = methodName(settings) + ' ' + settingsText(settings);
    // Cells that many cells would be too small for end at the same size.
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
  checkBudget(budget);
  require(!predictions.empty(), "choice of shadows: nothing to choose among");
  const auto fastest = std::min_element(predictions.begin(), predictions.end(), faster);
  if (fastest->time.milliseconds() > budget.milliseconds) failOnTime(*fastest, budget.milliseconds);
  const bool byError = std::isfinite(budget.maxError);
  const PredictedShadow* chosen = nullptr;
  const PredictedShadow* nearest = nullptr;
  for (const PredictedShadow& p : predictions) {
    if (p.time.milliseconds() > budget.milliseconds) continue;
    if (!nearest || p.cautiousError() < nearest->cautiousError()) nearest = &p;
    if (byError && p.cautiousError() > budget.maxError) continue;
    const bool better =
        !chosen ||
        (byError ? std::tuple(p.time.milliseconds(), p.error.meanAbsolute) <
                       std::tuple(chosen->time.milliseconds(), chosen->error.meanAbsolute)
                 : std::tuple(p.error.meanAbsolute, p.time.milliseconds()) <
                       std::tuple(chosen->error.meanAbsolute, chosen->time.milliseconds()));
    if (better) chosen = &p;
  }
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
    // All that follow are slower.
    if (std::isfinite(budget.maxError) && predicted.back().cautiousError() <= budget.maxError)
      break;
  }
  require(!predicted.empty(), "choice of shadows: nothing can shadow this hair; ", failure);
  ShadowChoice choice = chooseAmong(predicted, budget);
  choice.reason +=
      text("; error predicted from ", pilot.pointCount(), " points x ", pilot.rays(), " rays");
  return choice;
}

}  // namespace hair

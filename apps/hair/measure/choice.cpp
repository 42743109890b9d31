#include <apps/hair/measure/choice.h>

#include <iomanip>
#include <iostream>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/core/random.h>

namespace hair {

namespace {

constexpr const char* kMethod = "chosen";

std::string fixed(double value, int digits) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

// "measured / predicted 1.03".
std::string ratio(double measured, double predicted) {
  return "measured / predicted " + fixed(measured / predicted, 2);
}

}  // namespace

ShadowChoice addChoice(const MeasureReport& report, const LightSpace& light, float footprint,
                       const ShadowBudget& budget, const MachineCosts& machine,
                       std::vector<ShadowCandidate>& candidates) {
  PilotSettings pilot;
  // Other points and rays than those that it will be measured by.
  pilot.seed ^= hashWord(report.options.seed);
  const ShadowChoice choice = chooseShadow(report.hair.strands, report.hair.fibre, light, footprint,
                                           budget, machine, pilot);
  candidates.push_back({kMethod, kMethod, choice.predicted.candidate.settings});
  return choice;
}

void printChoice(const ShadowChoice& choice, const std::vector<ShadowTrial>& trials,
                 std::ostream& out) {
  const PredictedShadow& p = choice.predicted;
  out << "  chosen: " << p.candidate.label << ", " << choice.reason << "\n    predicted error "
      << fixed(p.error.meanAbsolute, 4) << " \xC2\xB1 " << fixed(p.error.standardError, 4)
      << ", build " << fixed(p.time.buildMilliseconds, 2) << " ms, sample "
      << fixed(p.time.sampleMilliseconds, 2) << " ms\n";
  for (const ShadowTrial& trial : trials) {
    if (trial.failed() || trial.candidate.method != kMethod) continue;
    out << "    measured  error " << fixed(trial.error.meanAbsolute.value, 4) << " \xC2\xB1 "
        << fixed(trial.error.meanAbsolute.standardError, 4) << ", build "
        << fixed(trial.buildMilliseconds, 2) << " ms, sample " << fixed(trial.sampleMilliseconds, 2)
        << " ms: error " << ratio(trial.error.meanAbsolute.value, p.error.meanAbsolute) << ", time "
        << ratio(trial.milliseconds(), p.time.milliseconds()) << '\n';
  }
  out << '\n';
}

}  // namespace hair

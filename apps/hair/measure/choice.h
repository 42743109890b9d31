#pragma once

#include <iosfwd>
#include <vector>

#include <apps/hair/measure/measure_report.h>
#include <libhair/measure/shadow/choose.h>

namespace hair {

/// Chooses for a light and a footprint, says what and why, and appends the choice to the candidates
/// as one more method, `chosen`.
ShadowChoice addChoice(const MeasureReport& report, const LightSpace& light, float footprint,
                       const ShadowBudget& budget, const MachineCosts& machine,
                       std::vector<ShadowCandidate>& candidates);

/// Two lines: predicted, and measured as a trial of the choice was.
void printChoice(const ShadowChoice& choice, const std::vector<ShadowTrial>& trials,
                 std::ostream& out);

}  // namespace hair

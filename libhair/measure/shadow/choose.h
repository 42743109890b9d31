#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/measure/shadow/candidates.h>
#include <libhair/measure/shadow/cost_model.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// What shadows may cost. Either or both; infinite: no limit.
struct ShadowBudget {
  /// Mean absolute error of transmittance, > 0.
  double maxError = std::numeric_limits<double>::infinity();
  /// Build and sample at all points of the hair, on the machine of the MachineCosts, > 0.
  double milliseconds = std::numeric_limits<double>::infinity();
};

/// Settings, and what they are predicted to do.
struct PredictedShadow {
  ShadowCandidate candidate;  ///< the settings
  PredictedTime time;         ///< to build and sample
  PredictedError error;       ///< against rays through fibres

  /// What a limit of errors is held against: the prediction and one standard error of it.
  double cautiousError() const { return error.meanAbsolute + error.standardError; }
};

/// What was chosen, and why.
struct ShadowChoice {
  PredictedShadow predicted;  ///< the winner
  std::string reason;         ///< for people: what limits, and what it was chosen among
  std::size_t tried = 0;      ///< candidates whose error was predicted
};

/// All settings that a choice is made among: those of shadowCandidates but the ones that are there
/// for the sake of their papers (their filters and extinction; another row does better at the same
/// cost), and the density map with cells from a third of the footprint to four of them.
std::vector<ShadowCandidate> choiceCandidates(StrandView strands, const LightSpace& light,
                                              float footprint);

/// Among predictions: with a limit of errors the fastest that keeps it (and that of time, if there
/// is one); with a limit of time alone the most accurate. So a larger limit of errors never costs
/// more predicted time, and a larger limit of time never predicts a larger error. Throws Error
/// where a limit is not positive, both are infinite, or none of the predictions keeps them: it says
/// what is nearest, and what to change.
ShadowChoice chooseAmong(const std::vector<PredictedShadow>& predictions,
                         const ShadowBudget& budget);

/// Chooses for this hair among choiceCandidates: times by the machine's costs, errors by a pilot on
/// the hair itself, in the order of predicted times and only as far as they can matter. For equal
/// arguments, MachineCosts included, the choice has the same bits in every run. Throws Error as
/// chooseAmong does.
ShadowChoice chooseShadow(StrandView strands, const Fibre& fibre, const LightSpace& light,
                          float footprint, const ShadowBudget& budget, const MachineCosts& machine,
                          const PilotSettings& pilot = {});

}  // namespace hair

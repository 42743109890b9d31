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

/// Limits of a choice: of the error, of the time, or of both; infinite: no limit.
struct ShadowBudget {
  /// Mean absolute error of transmittance, > 0.
  double maxError = std::numeric_limits<double>::infinity();
  /// Time to build and to sample at all points of the hair, on the machine of the MachineCosts, >
  /// 0.
  double milliseconds = std::numeric_limits<double>::infinity();
};

/// Settings with their predicted time and error.
struct PredictedShadow {
  ShadowCandidate candidate;  ///< the settings
  PredictedTime time;         ///< to build and sample
  PredictedError error;       ///< against rays through fibres

  /// Compared with the limit of the error: the prediction plus one standard error.
  double cautiousError() const { return error.meanAbsolute + error.standardError; }
};

/// The chosen settings, and the reason.
struct ShadowChoice {
  PredictedShadow predicted;  ///< the winner
  std::string reason;         ///< readable text: the limits, and the size of the pilot
  std::size_t tried = 0;      ///< candidates whose error was predicted
};

/// All settings that chooseShadow considers: those of shadowCandidates, without those that only
/// reproduce their papers (their filters and extinction; another row is better at the same cost)
/// and uncompressed deep shadow maps; and density maps with cells from a third of the footprint to
/// four footprints. Throws Error as shadowCandidates.
std::vector<ShadowCandidate> choiceCandidates(StrandView strands, const LightSpace& light,
                                              float footprint);

/// Chooses among predictions: with a limit of the error, the fastest within it (and within that of
/// time, if there is one); with a limit of time alone, the most accurate. So a larger limit of the
/// error never costs more predicted time, and a larger limit of time never predicts a larger error.
/// Throws Error where a limit is not positive, both are infinite, or no prediction meets them: it
/// names the nearest one, and what to change.
ShadowChoice chooseAmong(const std::vector<PredictedShadow>& predictions,
                         const ShadowBudget& budget);

/// Chooses among choiceCandidates for this hair: predicts times from the machine's costs and errors
/// by a pilot on the hair itself, fastest first, until no slower candidate can win. For equal
/// arguments, MachineCosts included, the choice has the same bits in every run. Throws Error as
/// chooseAmong and ErrorPilot do, and where no candidate can shadow this hair.
ShadowChoice chooseShadow(StrandView strands, const Fibre& fibre, const LightSpace& light,
                          float footprint, const ShadowBudget& budget, const MachineCosts& machine,
                          const PilotSettings& pilot = {});

}  // namespace hair

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/shadow_trial.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// Stages of shadow methods whose time is predicted, each with its own coefficients.
inline constexpr std::size_t kCostStages = 15;
/// Largest number of coefficients of a stage.
inline constexpr std::size_t kCostTerms = 5;

/// Amounts of the operations that take the time of a stage, or their costs.
using CostTerms = std::array<double, kCostTerms>;

/// Speed of a machine with some number of threads, in nanoseconds per unit of a term. Plain
/// numbers: fitted once by calibrate(), valid while machine, threads and library are the same.
struct MachineCosts {
  std::array<CostTerms, kCostStages> nanoseconds{};  ///< [stage][term]
  int threads = 0;                                   ///< threads at calibration
};

/// One line per stage: its name and its coefficients, nanoseconds.
std::string costText(const MachineCosts& machine);

/// Times every stage on this hair (some thousand strands or more, to tell the stages apart) under
/// an oblique light, with threadCount() threads: on the strands in their order, in random order,
/// and on half of them with a third of their points, at several resolutions; the least of `repeats`
/// (>= 1) rounds counts. Fits non-negative coefficients with the least sum of squared relative
/// errors. Throws Error for no repeats, and for hair of less than 2 strands or without inner
/// points.
MachineCosts calibrate(StrandView strands, const Fibre& fibre, int repeats = 3);
/// Calibrates on the built-in smooth style; takes seconds.
MachineCosts calibrate();

/// Predicted time of some settings on a machine.
struct PredictedTime {
  double buildMilliseconds = 0;   ///< with memory allocated by an earlier build
  double sampleMilliseconds = 0;  ///< at all points of the hair
  /// Their sum: the cost of a frame with moving hair.
  double milliseconds() const { return buildMilliseconds + sampleMilliseconds; }
};

/// Size of the pilot. Most of a prediction's standard error comes from the choice of points, as
/// errors have long tails. Rays are added until errors can be told from noise: wide fibres need
/// few, and their rays are slow.
struct PilotSettings {
  std::uint32_t points = 5000;    ///< >= 8; fewer where the hair has fewer
  std::uint32_t leastRays = 64;   ///< per point, >= 8, in two independent halves
  std::uint32_t mostRays = 1024;  ///< >= leastRays
  /// Rays are quadrupled until the noise of the truth (root mean square) is below this, or until
  /// mostRays.
  float noise = 5e-3f;
  std::uint32_t seed = 0x9107u;  ///< of points and rays
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const PilotSettings*) {
  using S = PilotSettings;
  return std::tuple(Field("points", &S::points, "[8, inf)"),
                    Field("leastRays", &S::leastRays, "[8, inf)"),
                    Field("mostRays", &S::mostRays, "[8, inf)"),
                    Field("noise", &S::noise, "[0, inf)"), Field("seed", &S::seed));
}

/// Expected mean absolute error of transmittance at the points of the hair, and the standard error
/// of that, from the pilot's choice of points and rays.
struct PredictedError {
  double meanAbsolute = 0;   ///< of transmittance
  double standardError = 0;  ///< of meanAbsolute
};

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

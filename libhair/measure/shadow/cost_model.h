#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/measure/shadow/hair_features.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// The stages of shadow methods whose time is predicted, each with coefficients of its own.
enum class CostStage {
  DepositPoints,         ///< density map, whole build with that deposit
  DepositColumns,        ///< the same with Deposit::Columns
  DepositSegments,       ///< the same with Deposit::Segments
  SampleCells,           ///< density map, filters of one or eight cells
  SampleFootprint,       ///< density map, Filter::Footprint
  ShadowMapBuild,        ///< shadow map
  ShadowMapSample,       ///< shadow map
  OpacityMapBuild,       ///< opacity shadow map
  OpacityMapSample,      ///< opacity shadow map
  DeepOpacityMapBuild,   ///< deep opacity map
  DeepOpacityMapSample,  ///< deep opacity map
  ClusteringBuild,       ///< density clustering
  ClusteringSample,      ///< density clustering
  DeepShadowMapBuild,    ///< deep shadow map
  DeepShadowMapSample,   ///< deep shadow map
  Count                  ///< how many there are
};
/// How many stages are predicted.
inline constexpr std::size_t kCostStages = static_cast<std::size_t>(CostStage::Count);
/// Coefficients of a stage, at the most.
inline constexpr std::size_t kCostTerms = 5;

/// How often a stage does what takes its time; costTerms says what each is.
using CostTerms = std::array<double, kCostTerms>;

/// How fast this machine is, with this many threads, in nanoseconds a term. Plain numbers: fitted
/// once by calibrate(), then kept for as long as machine, threads and library are the same.
struct MachineCosts {
  std::array<CostTerms, kCostStages> nanoseconds{};  ///< [stage][term]
  int threads = 0;                                   ///< that it was calibrated with
};

/// A line a stage: its name and its coefficients, nanoseconds.
std::string costText(const MachineCosts& machine);

/// The stages that these settings build and sample with.
struct CostStages {
  CostStage build,  ///< of everything that is kept for a frame
      sample;       ///< of transmittance at all points
};
/// The stages of these settings.
CostStages costStages(const ShadowSettings& settings);

/// What a stage does with this hair:
///  - density map, build: segments (points), cells crossed, places of bricks in the
///    map's table, cells of bricks that hold hair; and what caches miss: cells crossed ·
///    coldShare · log2 of its megabytes;
///  - density map, sample: points, cells read (rows of bricks for Footprint), points · log2 of the
///    map's megabytes: what caches miss;
///  - images, build: segments, fragments, words (pixels · layers); with lists of fragments:
///    fragments · log2 of the fragments a pixel instead of words, and fragments · clusters; and
///    what caches miss;
///  - images, sample: points, points · what a point reads.
CostTerms costTerms(CostStage stage, const HairFeatures& hair, const ShadowSettings& settings);

/// How long these settings should take on a machine.
struct PredictedTime {
  double buildMilliseconds = 0;   ///< in memory that an earlier build has left
  double sampleMilliseconds = 0;  ///< at all points of the hair
  /// Both together: what a frame with moving hair pays.
  double milliseconds() const { return buildMilliseconds + sampleMilliseconds; }
};
/// The sum of costTerms times the machine's coefficients, of build and of sample.
PredictedTime predictTime(const MachineCosts& machine, const HairFeatures& hair,
                          const ShadowSettings& settings);

/// Times every stage on hair (nothing less than some thousand strands tells stages apart), under a
/// slanting light, with threadCount() threads: on the strands as they are, in random order, and on
/// half of them with a third of their points, at several resolutions, the least of `repeats` (>= 1)
/// rounds. Coefficients are not negative and have the least sum of squared relative errors.
MachineCosts calibrate(StrandView strands, const Fibre& fibre, int repeats = 3);
/// On the built-in smooth style; seconds.
MachineCosts calibrate();

}  // namespace hair

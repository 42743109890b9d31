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

/// The stages of shadow methods whose time is predicted, each with its own coefficients.
enum class CostStage {
  DepositPoints,         ///< density map, whole build with Deposit::Points
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
  Count                  ///< number of stages
};
/// Number of stages.
inline constexpr std::size_t kCostStages = static_cast<std::size_t>(CostStage::Count);
/// Largest number of coefficients of a stage.
inline constexpr std::size_t kCostTerms = 5;

/// Amounts of the operations that take the time of a stage; costTerms defines them.
using CostTerms = std::array<double, kCostTerms>;

/// Speed of a machine with some number of threads, in nanoseconds per unit of a term. Plain
/// numbers: fitted once by calibrate(), valid while machine, threads and library are the same.
struct MachineCosts {
  std::array<CostTerms, kCostStages> nanoseconds{};  ///< [stage][term]
  int threads = 0;                                   ///< threads at calibration
};

/// One line per stage: its name and its coefficients, nanoseconds.
std::string costText(const MachineCosts& machine);

/// The stages that these settings build and sample with.
struct CostStages {
  CostStage build,  ///< builds all that is kept for a frame
      sample;       ///< samples transmittance at all points
};
/// The stages of these settings.
CostStages costStages(const ShadowSettings& settings);

/// The terms of a stage for this hair, one after the other:
///  - density map, build: segments (points for Points), cells crossed,
///    entries of the map's table of bricks, cells of bricks that hold hair; and for cache misses:
///    cells crossed · coldShare · log2 of the map's megabytes;
///  - density map, sample: points, cells read (rows of bricks for Footprint); and for cache misses:
///    points, cells read and points · coldShare, each times log2 of the map's megabytes;
///  - images, build: segments, fragments, words (pixels · layers), and for cache misses fragments ·
///    coldShare · log2 of the image's megabytes; with lists of fragments, fragments · log2 of the
///    fragments per pixel instead of words, and fragments · clusters;
///  - images, sample: points, points · amount read per point.
CostTerms costTerms(CostStage stage, const HairFeatures& hair, const ShadowSettings& settings);

/// Predicted time of some settings on a machine.
struct PredictedTime {
  double buildMilliseconds = 0;   ///< with memory allocated by an earlier build
  double sampleMilliseconds = 0;  ///< at all points of the hair
  /// Their sum: the cost of a frame with moving hair.
  double milliseconds() const { return buildMilliseconds + sampleMilliseconds; }
};
/// The sum of costTerms times the machine's coefficients, of build and of sample.
PredictedTime predictTime(const MachineCosts& machine, const HairFeatures& hair,
                          const ShadowSettings& settings);

/// Times every stage on this hair (some thousand strands or more, to tell the stages apart) under
/// an oblique light, with threadCount() threads: on the strands in their order, in random order,
/// and on half of them with a third of their points, at several resolutions; the least of `repeats`
/// (>= 1) rounds counts. Fits non-negative coefficients with the least sum of squared relative
/// errors. Throws Error for no repeats, and for hair of less than 2 strands or without inner
/// points.
MachineCosts calibrate(StrandView strands, const Fibre& fibre, int repeats = 3);
/// Calibrates on the built-in smooth style; takes seconds.
MachineCosts calibrate();

}  // namespace hair

#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <libhair/core/strands.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/measure/shadow/hair_features.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

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
static_assert(static_cast<std::size_t>(CostStage::Count) == kCostStages);

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

/// The sum of costTerms times the machine's coefficients, of build and of sample.
PredictedTime predictTime(const MachineCosts& machine, const HairFeatures& hair,
                          const ShadowSettings& settings);

}  // namespace hair

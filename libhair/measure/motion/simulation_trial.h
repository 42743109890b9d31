#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/measure/motion/scene.h>

namespace HAIR_API hair {

/// How far tips are from where another run of the same scene has them, metres.
struct TipDistance {
  double early = 0;  ///< root of the mean square over tips and the first `earlyFrames` frames
  double rms = 0;    ///< over tips and all frames
  double late = 0;   ///< over tips and the last `earlyFrames` frames
  double max = 0;    ///< of one tip in one frame
};

/// One run, and how far it is from the run that it is compared with.
struct SimulationRow {
  int substeps = 0;                            ///< a frame
  LinkSolver linkSolver = LinkSolver::Direct;  ///< how links were kept at their lengths
  int iterations = 0;                          ///< of the link solver a substep
  std::size_t guides = 0;                      ///< that were simulated
  TipDistance tips;                            ///< from the run compared with
  float stretchMax = 0;                        ///< GuideStats, the worst of all frames
  float penetrationMax = 0;                    ///< metres
  double guidesMs = 0;                         ///< median of Stage::Guides
  double wispsMs = 0;                          ///< median of Stage::Wisps
};

/// What is run. Every count is of a frame of the scene.
struct SimulationTrialSettings {
  int frames = 120;                               ///< of each run, >= 1
  int earlyFrames = 30;                           ///< of TipDistance; no more than frames
  int referenceSubsteps = 64;                     ///< even; of the converged run
  std::vector<int> substeps{1, 2, 4, 8, 16, 32};  ///< a frame; a row for each
  std::vector<int> iterations{1, 4};  ///< beside the scene's own, at the scene's own substeps
  std::vector<int> relaxation{1, 2, 4, 8, 16, 32};  ///< iterations of LinkSolver::Relaxation there
};

/// Time against accuracy of the guides' integration.
///
/// The converged run is the same guides, from the same settled state, with many more substeps a
/// frame. So is a run with half as many, and the distance between these two is the reference's own
/// uncertainty: the method is of first order (implicit Euler), so that the reference is about as
/// far from the limit as its half is from it. Errors below that mean nothing.
///
/// More substeps are not better without end. A substep moves a point by g h², and a metre from the
/// origin that is rounded away in single precision: at 60 frames a second, 32 substeps there are
/// the most that converge. The reference (not the rows) is therefore run with the head brought to
/// the origin, which is good for 64; where it is not enough its uncertainty says so. In wind, whose
/// gusts know where they are, the reference stays where it is.
///
/// Known limits. Hair in contact hangs on a shoulder or slips off it by a hair's breadth, and is
/// then centimetres off for good. Once strands have parted in this way, means count them and not
/// the error of the integration: where the reference's own distance grows from `early` to `late`,
/// believe `early`, or take fewer frames. In the built-in dance (smooth style) all three means are
/// alike for some seconds, as drag and friction forget; after ten seconds the last frames' are ten
/// times the first's. `twin` says what an arbitrarily small difference comes to: the scene's own
/// settings again, but every point starts 0.01 mm/s faster. Distances that are not well above the
/// twin's over the same frames say nothing about substeps. `max` is mostly one tip that fell on the
/// other side of something. Poses are known at frames and blended between them in every run: the
/// error of that is in none of them, nor is that of the settled state, which all runs share.
struct SubstepTrial {
  SimulationRow reference;  ///< its distance: from the run with half its substeps
  SimulationRow twin;       ///< of the scene's own settings; its distance: from their run
  /// `substeps`, `iterations`, `relaxation`; distance from the reference, which is solved as the
  /// scene is.
  std::vector<SimulationRow> rows;
};

/// Tips are the guides'. Shadows and shading are not run; self-collision as the scene's settings
/// say (its push is taken once a frame, whatever the substeps).
/// Throws Error for settings out of range.
SubstepTrial measureSubsteps(const MeasuredScene& scene, const SimulationTrialSettings& settings);

/// Time against what fewer guides change of the drawn hair.
struct GuideCountTrial {
  SimulationRow all;                ///< the scene's own groom; distance 0
  SimulationRow twin;               ///< as in SubstepTrial, but of the drawn strands
  std::vector<SimulationRow> rows;  ///< distance from the run of the scene's own groom
};

/// Binds the groom's drawn strands, as they are at rest, to each of `counts` guides (bindGroom) and
/// performs the scene with them. Tips are the drawn strands', so they start within rounding of each
/// other whatever the count, but for what settling does. A groom that was itself bound (a loaded
/// one) is met again at its own count; a built-in style grew with three guides a wisp, so that the
/// row with as many guides says what binding alone changes. The wisps of a style cannot be thinned
/// without growing other strands (StyleSettings::wisps), which leaves nothing to compare.
/// Throws Error for settings out of range.
GuideCountTrial measureGuideCounts(const MeasuredScene& scene, std::span<const std::size_t> counts,
                                   const SimulationTrialSettings& settings);

}  // namespace hair

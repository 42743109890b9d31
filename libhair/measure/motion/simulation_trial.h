#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/measure/motion/scene.h>

namespace HAIR_API hair {

/// Distances of tips between two runs of the same scene, metres.
struct TipDistance {
  double early = 0;  ///< root of the mean square over tips and the first `earlyFrames` frames
  double rms = 0;    ///< over tips and all frames
  double late = 0;   ///< over tips and the last `earlyFrames` frames
  double max = 0;    ///< of one tip in one frame
};

/// One run, and its distance from the run that it is compared with.
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
/// Single precision limits the number of substeps. A substep changes a point's motion by g h²,
/// which a metre from the origin is below the rounding error: at 60 frames a second at most 32
/// substeps converge there. The reference (not the rows) therefore runs with the head moved to the
/// origin, which is good for 64; if that is not enough, its uncertainty shows it. In wind, whose
/// gusts depend on the place, the reference is not moved.
///
/// Known limits. Contact is chaotic: whether hair stays on a shoulder or slips off depends on tiny
/// differences, and then changes tips by centimetres for good. From then on means measure such
/// strands instead of the integration error: where the reference's own distance grows from `early`
/// to `late`, use `early`, or fewer frames. In the built-in dance (smooth style) all three means
/// agree for some seconds, because drag and friction damp differences; after ten seconds the last
/// frames' are ten times the first's. `twin` measures the growth of a minimal perturbation: the
/// scene's own settings, but every point starts 0.01 mm/s faster. Distances not well above the
/// twin's over the same frames say nothing about substeps. `max` is mostly a single tip that fell
/// on the other side of a collider. Errors common to all runs are not included: interpolation of
/// poses between frames, and the settled state.
struct SubstepTrial {
  SimulationRow reference;  ///< its distance: from the run with half its substeps
  SimulationRow twin;       ///< of the scene's own settings; its distance: from their run
  /// `substeps`, `iterations`, `relaxation`; distance from the reference, which is solved as the
  /// scene is.
  std::vector<SimulationRow> rows;
};

/// Measures tips of guides, without shadows and shading. Self-collision follows the scene's
/// settings (the push is constant during a frame, for any number of substeps). Throws Error for
/// settings out of range.
SubstepTrial measureSubsteps(const MeasuredScene& scene, const SimulationTrialSettings& settings);

/// Time against the change of drawn hair with fewer guides.
struct GuideCountTrial {
  SimulationRow all;                ///< the scene's own groom; distance 0
  SimulationRow twin;               ///< as in SubstepTrial, but of the drawn strands
  std::vector<SimulationRow> rows;  ///< distance from the run of the scene's own groom
};

/// Binds the groom's drawn strands, as they are at rest, to each of `counts` guides (bindGroom) and
/// runs the scene with them. Measures tips of drawn strands, which for all counts start within
/// rounding of each other, except for settling. A groom that was itself bound (a loaded one) is
/// reproduced at its own count; a built-in style has three guides a wisp, so the row with as many
/// guides measures the effect of binding alone. Fewer wisps of a style would grow other strands
/// (StyleSettings::wisps), which cannot be compared.
/// Throws Error for settings out of range.
GuideCountTrial measureGuideCounts(const MeasuredScene& scene, std::span<const std::size_t> counts,
                                   const SimulationTrialSettings& settings);

}  // namespace hair

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// One row of a table that compares shadow methods and their settings.
struct ShadowCandidate {
  std::string method;  ///< methodName, or "auto": the density map that automaticMapSettings chose
  std::string label;   ///< "density map 3 mm ...", or "auto"; unique in a list, without commas
  ShadowSettings settings;  ///< what makeShadowMethod takes
};

/// Extent of a list of candidates.
enum class CandidateSet {
  Quick,  ///< each method once, with good default settings for this footprint, and `auto`
  All,    ///< each at several resolutions and layer counts, among them those of its own paper
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(CandidateSet) {
  return std::array{Word("quick", CandidateSet::Quick), Word("all", CandidateSet::All)};
}

/// Settings to compare for shadows averaged over a disc of radius `footprint` (metres, > 0), sized
/// for the strands' extent under this light. `auto` comes first. Throws Error for a footprint that
/// is not positive.
std::vector<ShadowCandidate> shadowCandidates(StrandView strands, const LightSpace& light,
                                              float footprint, CandidateSet set);

/// All values of ShadowCandidate::method, in the order of shadowCandidates.
std::span<const std::string> candidateMethods();

/// The scene of trials: hair under one light, and the truth at some of its points.
struct TrialScene {
  StrandView strands;                   ///< not owned
  Fibre fibre;                          ///< of each strand
  LightSpace light;                     ///< the light
  std::span<const SamplePoint> points;  ///< [truth.transmittance.size()]
  const Truth& truth;                   ///< not owned
  std::span<const glm::vec3> probes{};  ///< further points to sample, as on a ray
};

/// Cost and error of a shadow method with its settings.
struct ShadowTrial {
  ShadowCandidate candidate;  ///< what was tried
  std::string failure;  ///< why it cannot shadow this hair, with all below empty; empty: it can
  ErrorFigures error;   ///< at the scene's points
  double buildMilliseconds = 0;      ///< median; with memory allocated by an earlier build
  double sampleMilliseconds = 0;     ///< median; sampleStrands, all points of the hair
  double sampleNanoseconds = 0;      ///< the same per point
  std::size_t bytes = 0;             ///< ShadowMethod::bytes
  std::vector<float> transmittance;  ///< [scene.points.size()], by sampleStrands: without the own
                                     ///< strand, as in the truth, where the method can
  std::vector<float> probes;         ///< [scene.probes.size()], by sample

  /// Whether the method could not shadow this hair.
  bool failed() const { return !failure.empty(); }
  /// Build and sample: the cost of a frame with moving hair.
  double milliseconds() const { return buildMilliseconds + sampleMilliseconds; }
};

/// Runs every candidate `repeats` times (>= 1) and takes the median times. Rounds go over all
/// candidates, alternately forwards and backwards, so that a machine that slows down slows all
/// alike. Each timed build follows one that is not timed, which warms pages and caches; only one
/// candidate's memory is held at a time. A candidate that throws Error fails alone. All but the
/// times has the same bits in every run. Calls `done`, if any, after each of the candidates.size()
/// · repeats steps. Throws Error where points, truth and strands disagree.
std::vector<ShadowTrial> runTrials(std::span<const ShadowCandidate> candidates,
                                   const TrialScene& scene, int repeats,
                                   const std::function<void()>& done = {});

/// The most accurate (least mean absolute error) trial of each method, in the order of their first
/// appearance, without methods of which all trials failed. Indices into `trials`.
std::vector<std::size_t> bestOfEachMethod(std::span<const ShadowTrial> trials);

/// paretoFront of milliseconds() and mean absolute error, without those that failed.
std::vector<std::size_t> trialFront(std::span<const ShadowTrial> trials);

}  // namespace hair

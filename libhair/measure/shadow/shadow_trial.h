#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/measure/shadow/candidates.h>
#include <libhair/measure/shadow/error_figures.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// What ways to shadow are tried on: hair under one light, and the truth at some of its points.
struct TrialScene {
  StrandView strands;                   ///< not owned
  Fibre fibre;                          ///< what each strand stands for
  LightSpace light;                     ///< where light comes from
  std::span<const SamplePoint> points;  ///< [truth.transmittance.size()]
  const Truth& truth;                   ///< not owned
  std::span<const glm::vec3> probes{};  ///< where else transmittance is wanted, on a ray say
};

/// What a way to shadow costs, and how far from the truth it is.
struct ShadowTrial {
  ShadowCandidate candidate;  ///< what was tried
  std::string failure;  ///< why it cannot shadow this hair; empty: it can. All below is empty else
  ErrorFigures error;   ///< at the scene's points
  double buildMilliseconds = 0;      ///< median; in memory that an earlier build has left
  double sampleMilliseconds = 0;     ///< median; sampleStrands, all points of the hair
  double sampleNanoseconds = 0;      ///< that, a point
  std::size_t bytes = 0;             ///< ShadowMethod::bytes
  std::vector<float> transmittance;  ///< [scene.points.size()], by sampleStrands: own strand left
                                     ///< out, as in the truth, where the method knows how
  std::vector<float> probes;         ///< [scene.probes.size()], by sample

  /// Whether `failure` says anything.
  bool failed() const { return !failure.empty(); }
  /// Build and sample: what a frame with moving hair pays.
  double milliseconds() const { return buildMilliseconds + sampleMilliseconds; }
};

/// Tries every candidate `repeats` times (>= 1) and takes the median times. Rounds go over all
/// candidates, there and back by turns, so that a machine that slows down slows all alike. Before
/// every timed build there is one that is not, so that pages and caches are warm, and only one
/// candidate's memory is held at a time. A candidate that throws Error fails alone. Everything but
/// the times has the same bits in every run. `done`, if any, is called after each of the
/// candidates.size() · repeats steps. Throws Error where points, truth and strands disagree.
std::vector<ShadowTrial> runTrials(std::span<const ShadowCandidate> candidates,
                                   const TrialScene& scene, int repeats,
                                   const std::function<void()>& done = {});

/// The most accurate (least mean absolute error) trial of each method, in the order of their first
/// appearance; methods of which all failed are left out. Indices into `trials`.
std::vector<std::size_t> bestOfEachMethod(std::span<const ShadowTrial> trials);

/// paretoFront of milliseconds() and mean absolute error, without those that failed.
std::vector<std::size_t> trialFront(std::span<const ShadowTrial> trials);

}  // namespace hair

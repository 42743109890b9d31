#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/measure/motion/scene.h>

namespace HAIR_API hair {

/// Statistics of the whole scene during the measurement.
struct SceneWatch {
  std::int64_t frames = 0;  ///< frames observed
  double pushed = 0;        ///< share of guide points, over all frames, that self-collision pushes
  float darkest = 1;        ///< least transmittance of any point
  int cells = 0;            ///< of the light's map along each axis
  glm::ivec3 cellsUsed{0};  ///< the most that the hair spanned along each of the map's axes
  std::uint32_t saturatedCells = 0;  ///< the most of any frame
  /// Frames in which the hair exceeded the map of the settings, so that its cells were enlarged.
  std::int64_t enlargedFrames = 0;
};

/// A part of a scene that can be left out.
struct Feature {
  std::string name;                                ///< for people
  std::vector<Stage> stages;                       ///< that run for it alone; empty: none does
  std::function<bool(const MeasuredScene&)> isOn;  ///< in this scene
  std::function<void(MeasuredScene&)> turnOff;     ///< of a copy
  std::function<std::string(const SceneWatch&)> advice = nullptr;  ///< "": none; null: the same
};

/// The features that are on in this scene.
std::vector<Feature> featuresOf(const MeasuredScene& scene);

/// What a feature costs. Times are of a frame, in milliseconds.
struct FeatureCost {
  std::string name;             ///< Feature::name
  std::optional<double> ownMs;  ///< medians of its stages, added; none where it has no stage
  double savedMs = 0;           ///< median over blocks of what the frame is faster without it
  double savedMsError = 0;      ///< standard error of that
  double savedShare = 0;        ///< savedMs / FeaturePlan::frameMs
  double savedBytes = 0;  ///< hairBytes with it, less without; negative: leaving it out takes more
  /// What leaving it out changes, root of the mean square over points and blocks; none where the
  /// two have not the same points or colours to compare.
  std::optional<double> movedMetres;
  std::optional<double> recoloured;  ///< sRGB levels of 255, all channels
  std::optional<double> relit;       ///< transmittance; off counts as 1
  std::string advice;                ///< one line, or empty
};

/// What a scene costs as it is, and what each of its features does to that.
struct FeaturePlan {
  double frameMs = 0;                 ///< median of a frame with everything that is on
  double bytes = 0;                   ///< hairBytes then
  SceneWatch watch;                   ///< what was seen meanwhile
  std::vector<FeatureCost> features;  ///< in the order of the features measured
};

/// How long to measure.
struct FeatureCostSettings {
  int blocks = 24;         ///< >= 2
  int framesPerBlock = 5;  ///< >= 2; the first of a block warms the caches and is not counted
};

/// Measures the cost of each feature. Runs the scene as it is and once without each feature,
/// interleaved: a block of frames of each in turn, in reverse order every other time, so that
/// changes of machine load affect all runs alike. A saving is the median over blocks of (with -
/// without) of the blocks' median frames. It can exceed the feature's own stages (later stages have
/// less work) or fall below them (other hair, other contacts). Savings of two features do not add
/// up.
///
/// Known limits. Caches are warm only from the second frame of a block on. Covers only
/// FrameSettings and groom, not drawing, nor the shadow of head and body in Hair::visibility.
/// Throws Error for settings out of range.
FeaturePlan measureFeatures(const MeasuredScene& scene, std::span<const Feature> features,
                            const FeatureCostSettings& settings = {});

/// Bytes in the arrays of a head of hair: guides, drawn strands and their groom, maps, colours. Of
/// a map, the reserved memory; pages that hair never touches are not committed.
std::size_t hairBytes(const Hair& hair);

}  // namespace hair

#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// Most of a prediction's standard error is the choice of points: errors have long tails. Rays are
/// as many as it takes to tell errors from noise: broad fibres need few, and their rays are slow.
struct PilotSettings {
  std::uint32_t points = 5000;    ///< >= 8; fewer where the hair has fewer
  std::uint32_t leastRays = 64;   ///< a point, >= 8, in two halves that are independent
  std::uint32_t mostRays = 1024;  ///< >= leastRays
  /// Rays become four times as many until this is left of the truth's noise (root mean square), or
  /// until they are as many as may be.
  float noise = 5e-3f;
  std::uint32_t seed = 0x9107u;  ///< of points and rays
};

/// Mean absolute error of transmittance that is expected at points of the hair, and the standard
/// error of that: what the choice of the pilot's points and its rays leave open.
struct PredictedError {
  double meanAbsolute = 0;   ///< of transmittance
  double standardError = 0;  ///< of meanAbsolute
};

/// Few exact points of this hair, against which any settings can be tried at the cost of one build.
///
/// The truth of few rays is noisy, and noise on top of an error makes its absolute value larger on
/// average. What the two halves of the rays, T1 and T2, say alone has twice the variance of the
/// noise of T = (T1 + T2) / 2; in a straight line from there to no noise at all:
///
///   mean|m - T| - ( mean(|m - T1| + |m - T2|) / 2 - mean|m - T| )
///
/// (Cook and Stefanski 1994, "Simulation-Extrapolation Estimation in Parametric Measurement Error
/// Models", with noise that is there anyway.) Exact for noise far below the error.
class ErrorPilot {
 public:
  /// `footprint`: metres, > 0. The strands must outlive the pilot. Throws Error for settings out of
  /// range, and for hair that has no points but roots.
  ErrorPilot(StrandView strands, const Fibre& fibre, const LightSpace& light, float footprint,
             const PilotSettings& settings = {});

  /// Builds and samples once. Same bits for any number of threads. Throws Error where the settings
  /// cannot shadow this hair.
  PredictedError predict(const ShadowSettings& settings);

  /// Points of the pilot.
  std::size_t pointCount() const { return points_.size(); }
  std::uint32_t rays() const { return rays_; }  ///< a point, both halves

 private:
  StrandView strands_;
  Fibre fibre_;
  LightSpace light_;
  std::vector<SamplePoint> points_;
  Truth first_, second_;  // of a half of the rays each
  Truth both_;
  std::uint32_t rays_ = 0;
  std::vector<float> all_, measured_;  // scratch: at all points, and at points_
};

}  // namespace hair

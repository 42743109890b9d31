#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Predicts the error of any settings at the cost of one build, against traced rays at few points
/// of this hair.
///
/// The truth of few rays is noisy, and noise increases the mean absolute error. Each half of the
/// rays, T1 and T2, has twice the variance of the noise of T = (T1 + T2) / 2; linear extrapolation
/// from there to no noise gives
///
///   mean|m - T| - ( mean(|m - T1| + |m - T2|) / 2 - mean|m - T| )
///
/// (Cook and Stefanski 1994, "Simulation-Extrapolation Estimation in Parametric Measurement Error
/// Models", here without adding noise.) Accurate for noise far below the error.
class ErrorPilot {
 public:
  /// `footprint`: metres, > 0. The strands must outlive the pilot. Throws Error for settings out of
  /// range, and for hair that has no points but roots.
  ErrorPilot(StrandView strands, const Fibre& fibre, const LightSpace& light, float footprint,
             const PilotSettings& settings = {});

  /// Predicts the error of these settings: builds and samples once. Same bits for any number of
  /// threads. Throws Error where the settings cannot shadow this hair.
  PredictedError predict(const ShadowSettings& settings);

  /// Number of points of the pilot.
  std::size_t pointCount() const { return points_.size(); }
  std::uint32_t rays() const { return rays_; }  ///< per point, both halves

 private:
  StrandView strands_;
  Fibre fibre_;
  LightSpace light_;
  std::vector<SamplePoint> points_;
  Truth first_, second_;  // of one half of the rays each
  Truth both_;
  std::uint32_t rays_ = 0;
  std::vector<float> all_, measured_;  // scratch: at all points, and at points_
};

}  // namespace hair

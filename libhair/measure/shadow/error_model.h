#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// Size of the pilot. Most of a prediction's standard error comes from the choice of points, as
/// errors have long tails. Rays are added until errors can be told from noise: wide fibres need
/// few, and their rays are slow.
struct PilotSettings {
  std::uint32_t points = 5000;    ///< >= 8; fewer where the hair has fewer
  std::uint32_t leastRays = 64;   ///< per point, >= 8, in two independent halves
  std::uint32_t mostRays = 1024;  ///< >= leastRays
  /// Rays are quadrupled until the noise of the truth (root mean square) is below this, or until
  /// mostRays.
  float noise = 5e-3f;
  std::uint32_t seed = 0x9107u;  ///< of points and rays
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const PilotSettings*) {
  using S = PilotSettings;
  return std::tuple(Field("points", &S::points, "[8, inf)"),
                    Field("leastRays", &S::leastRays, "[8, inf)"),
                    Field("mostRays", &S::mostRays, "[8, inf)"),
                    Field("noise", &S::noise, "(0, inf)"), Field("seed", &S::seed));
}

/// Expected mean absolute error of transmittance at the points of the hair, and the standard error
/// of that, from the pilot's choice of points and rays.
struct PredictedError {
  double meanAbsolute = 0;   ///< of transmittance
  double standardError = 0;  ///< of meanAbsolute
};

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

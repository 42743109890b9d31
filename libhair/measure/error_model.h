#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/strands.h>
#include <libhair/measure/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/light_space.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

struct PilotSettings {
  std::uint32_t points = 600;  ///< >= 8; fewer where the hair has fewer
  std::uint32_t rays = 512;    ///< a point, >= 8, in two halves that are independent
  std::uint32_t seed = 0x9107u;
};

/// Mean absolute error of transmittance that is expected at points of the hair, and the standard
/// error of that: what the choice of the pilot's points and its rays leave open.
struct PredictedError {
  double meanAbsolute = 0;
  double standardError = 0;
};

/// Few exact points of this hair, against which any settings can be tried at the cost of one build.
///
/// The truth of few rays is noisy, and noise on top of an error makes its absolute value larger on
/// average. Two halves of the rays, T1 and T2, are independent: the mean of (m - T1)(m - T2) is the
/// mean square of the error alone, without any bias. The mean absolute error against both halves
/// together is scaled by the root of that over the mean square with noise:
///
///   mean|m - T| · sqrt( mean (m - T1)(m - T2) / mean (m - T)² ),   T = (T1 + T2) / 2
///
/// exact where errors and noise have one shape of distribution; the noise is a few percent of what
/// is left to correct.
class ErrorPilot {
 public:
  /// `footprint`: metres, > 0. The strands must outlive the pilot. Throws Error for settings out of
  /// range, and for hair that has no points but roots.
  ErrorPilot(StrandView strands, const Fibre& fibre, const LightSpace& light, float footprint,
             const PilotSettings& settings = {});

  /// Builds and samples once. Same bits for any number of threads. Throws Error where the settings
  /// cannot shadow this hair.
  PredictedError predict(const ShadowSettings& settings);

  std::size_t pointCount() const { return points_.size(); }

 private:
  StrandView strands_;
  Fibre fibre_;
  LightSpace light_;
  std::vector<SamplePoint> points_;
  Truth first_, second_;  // of a half of the rays each
  Truth both_;
  std::vector<float> all_, measured_;  // scratch: at all points, and at points_
};

}  // namespace hair

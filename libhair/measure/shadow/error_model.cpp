#include <libhair/measure/shadow/error_model.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/measure/shadow/truth.h>

namespace hair {

ErrorPilot::ErrorPilot(StrandView strands, const Fibre& fibre, const LightSpace& light,
                       float footprint, const PilotSettings& settings)
    : strands_(strands), fibre_(fibre), light_(light) {
  require(footprint > 0 && std::isfinite(footprint), "shadow footprint: ", footprint,
          " m is not positive");
  validateFields(settings, "error pilot");
  require(settings.leastRays <= settings.mostRays, "error pilot: leastRays ", settings.leastRays,
          " is more than mostRays ", settings.mostRays);
  // Choose the points, and trace two independent halves of the rays until the noise is low enough.
  points_ = chooseSamplePoints(strands, settings.points, settings.seed);
  require(!points_.empty(), "error pilot: the hair has no points but roots to compare shadows at");
  const std::unique_ptr<FibreTracer> tracer = makeGridTracer(strands, fibre);
  const std::size_t n = points_.size();
  both_.transmittance.resize(n);
  for (rays_ = settings.leastRays;; rays_ = std::min(4 * rays_, settings.mostRays)) {
    const auto trace = [&](std::uint32_t half) {
      return exactTransmittance(*tracer, fibre, light, points_,
                                {footprint, rays_ / 2, hashWord(settings.seed ^ hashWord(half))});
    };
    first_ = trace(1);
    second_ = trace(2);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const float a = first_.transmittance[i], b = second_.transmittance[i];
      both_.transmittance[i] = 0.5f * (a + b);
      squares += static_cast<double>(a - b) * static_cast<double>(a - b);
    }
    // Estimate the noise of the mean from the difference of the halves: rays are stratified, so
    // that the standard error of independent rays would be too large.
    const auto noise = static_cast<float>(0.5 * std::sqrt(squares / static_cast<double>(n)));
    both_.standardError.assign(n, noise);
    if (noise <= settings.noise || rays_ >= settings.mostRays) break;
  }
  all_.resize(strands.pointCount());
  measured_.resize(n);
}

PredictedError ErrorPilot::predict(const ShadowSettings& settings) {
  // Build and sample, and free the method.
  {
    const std::unique_ptr<ShadowMethod> method = makeShadowMethod(settings);
    method->build(strands_, fibre_, light_);
    method->sampleStrands(strands_, all_);
  }
  // Extrapolate to no noise (SIMEX): halves of the rays have twice its variance, so subtract from
  // the error of all rays what that of the halves exceeds it by.
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    measured_[i] = all_[points_[i].point];
    const auto m = static_cast<double>(measured_[i]);
    const auto off = [&](const Truth& t) {
      return std::abs(m - static_cast<double>(t.transmittance[i]));
    };
    const double e = 2 * off(both_) - 0.5 * (off(first_) + off(second_));
    sum += e;
    squares += e * e;
  }
  const auto n = static_cast<double>(points_.size());
  const double mean = sum / n;
  return {std::max(mean, 0.0), std::sqrt(std::max(squares / n - mean * mean, 0.0) / n)};
}

}  // namespace hair

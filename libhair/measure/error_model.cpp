#include <libhair/measure/error_model.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/measure/error_figures.h>

namespace hair {

ErrorPilot::ErrorPilot(StrandView strands, const Fibre& fibre, const LightSpace& light,
                       float footprint, const PilotSettings& settings)
    : strands_(strands), fibre_(fibre), light_(light) {
  require(footprint > 0 && std::isfinite(footprint), "shadow footprint: ", footprint,
          " m is not positive; set --footprint");
  require(settings.points >= 8, "error pilot: ", settings.points, " points; take 8 or more");
  require(settings.rays >= 8, "error pilot: ", settings.rays, " rays a point; take 8 or more");
  points_ = chooseSamplePoints(strands, settings.points, settings.seed);
  require(!points_.empty(), "error pilot: the hair has no points but roots to compare shadows at");
  const std::unique_ptr<FibreTracer> tracer = makeGridTracer(strands, fibre);
  const auto trace = [&](std::uint32_t half) {
    return exactTransmittance(
        *tracer, fibre, light, points_,
        {footprint, settings.rays / 2, hashWord(settings.seed ^ hashWord(half))});
  };
  first_ = trace(1);
  second_ = trace(2);
  const std::size_t n = points_.size();
  double squares = 0;
  both_.transmittance.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float a = first_.transmittance[i], b = second_.transmittance[i];
    both_.transmittance[i] = 0.5f * (a + b);
    squares += static_cast<double>(a - b) * static_cast<double>(a - b);
  }
  // What the halves differ by says how noisy their mean is; that of plain random rays is too much.
  both_.standardError.assign(n,
                             static_cast<float>(0.5 * std::sqrt(squares / static_cast<double>(n))));
  all_.resize(strands.pointCount());
  measured_.resize(n);
}

PredictedError ErrorPilot::predict(const ShadowSettings& settings) {
  {
    const std::unique_ptr<ShadowMethod> method = makeShadowMethod(settings);
    method->build(strands_, fibre_, light_);
    method->sampleStrands(strands_, all_);
  }
  double without = 0, with = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    measured_[i] = all_[points_[i].point];
    const auto m = static_cast<double>(measured_[i]);
    without += (m - static_cast<double>(first_.transmittance[i])) *
               (m - static_cast<double>(second_.transmittance[i]));
    const double e = m - static_cast<double>(both_.transmittance[i]);
    with += e * e;
  }
  const ErrorFigures::Figure figure = errorFigures(measured_, both_).meanAbsolute;
  const double scale = with > 0 ? std::sqrt(std::max(without, 0.0) / with) : 1.0;
  return {figure.value * scale, figure.standardError};
}

}  // namespace hair

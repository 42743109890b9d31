#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// Temporal error of shadows on still hair while the light turns slowly.
///
/// Let T[k] be the transmittance of a point under light k, each turned by the same small angle from
/// the previous one. The true transmittance averaged over a footprint changes smoothly: over a few
/// steps of 0.1 degree almost linearly. Other changes are errors of the method:
///
///   shimmer  RMS over points and steps of (T[k-1] - 2 T[k] + T[k+1]) / sqrt(6). A line gives 0;
///            noise of standard deviation s from step to step, independent, gives s (1 + 4 + 1 =
///            6). It is visible as flicker from frame to frame.
///   swim     RMS distance of T from its regression line over all steps, with two degrees of
///   freedom
///            subtracted, so that the same noise gives s as well. It includes changes over several
///            steps, as of cells that move across the hair. The truth is not quite linear over all
///            steps either: compare with its own figure.
struct Flicker {
  double shimmer = 0;  ///< of transmittance
  double swim = 0;     ///< of transmittance
};

/// Rotation of the light.
struct FlickerSettings {
  float degrees = 0.1f;  ///< per step, (0, 90]
  int steps = 20;        ///< [2, 100000]
};

/// settings.steps + 1 lights, the first as given; a light at a point rotates about its pivot. The
/// axis is the direction nearest to +Y at a right angle to the light, so that its direction turns
/// by the whole angle. Throws Error for settings out of range.
std::vector<LightSpace> turningLights(const LightSpace& light, const FlickerSettings& settings);

/// Flicker of any method: `transmittance(light, out)` fills `out` [pointCount]. Throws Error for
/// less than 3 lights.
Flicker flickerOf(std::span<const LightSpace> lights, std::size_t pointCount,
                  const std::function<void(const LightSpace&, std::span<float>)>& transmittance);

/// Flicker of a shadow method at these points of the strands. Throws Error as the method does.
Flicker flickerOf(const ShadowSettings& settings, StrandView strands, const Fibre& fibre,
                  std::span<const LightSpace> lights, std::span<const SamplePoint> points);

/// Flicker of the truth, with its noise (the same rays under every light).
Flicker flickerOf(const FibreTracer& tracer, const Fibre& fibre, std::span<const LightSpace> lights,
                  std::span<const SamplePoint> points, const TruthSettings& settings);

}  // namespace hair

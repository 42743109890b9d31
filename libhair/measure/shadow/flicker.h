#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// How shadows on still hair move when the light turns slowly, beyond what they should.
///
/// Let T[k] be the transmittance of a point under light k, each turned by a small equal step from
/// the one before. The true transmittance of a disc as large as the footprint changes smoothly:
/// over a few steps of 0.1 degree almost along a line. What does not is the method's own:
///
///   shimmer  RMS over points and steps of (T[k-1] - 2 T[k] + T[k+1]) / sqrt(6). A line gives 0;
///            noise of standard deviation s from step to step, independent, gives s (1 + 4 + 1 =
///            6). It is what one sees as flicker from frame to frame.
///   swim     RMS distance of T from its straight line (least squares) over all steps, two degrees
///            of freedom taken off, so that the same noise gives s as well. It also holds what is
///            slower than a step: cells that pass under the hair. The truth bends a little over all
///            steps too: compare with the truth's own figure.
struct Flicker {
  double shimmer = 0;  ///< of transmittance
  double swim = 0;     ///< of transmittance
};

/// How the light turns.
struct FlickerSettings {
  float degrees = 0.1f;  ///< a step of the light, > 0
  int steps = 20;        ///< >= 2
};

/// settings.steps + 1 lights, the first as given; a light at a point goes round its pivot. The axis
/// is the line nearest to +Y at right angles to the light, so that all steps are whole.
/// Throws Error for settings out of range.
std::vector<LightSpace> turningLights(const LightSpace& light, const FlickerSettings& settings);

/// Of anything: `transmittance(light, out)` fills the transmittance of `pointCount` points.
Flicker flickerOf(std::span<const LightSpace> lights, std::size_t pointCount,
                  const std::function<void(const LightSpace&, std::span<float>)>& transmittance);

/// Of a way to shadow, at these points of the strands. Throws Error as the method does.
Flicker flickerOf(const ShadowSettings& settings, StrandView strands, const Fibre& fibre,
                  std::span<const LightSpace> lights, std::span<const SamplePoint> points);

/// Of the truth, its noise included (the same rays under every light).
Flicker flickerOf(const FibreTracer& tracer, const Fibre& fibre, std::span<const LightSpace> lights,
                  std::span<const SamplePoint> points, const TruthSettings& settings);

}  // namespace hair

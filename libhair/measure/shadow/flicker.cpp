#include <libhair/measure/shadow/flicker.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include <libhair/core/error.h>

namespace hair {

std::vector<LightSpace> turningLights(const LightSpace& light, const FlickerSettings& settings) {
  require(settings.degrees > 0 && settings.degrees <= 90, "flicker: a step of ", settings.degrees,
          " degrees is not in (0, 90]");
  require(settings.steps >= 2 && settings.steps <= 100'000, "flicker: ", settings.steps,
          " steps, needs 2 to 100000");
  const glm::dvec3 way = light.direction();
  // Take +X for a vertical light, where +Y has no component across it.
  const glm::dvec3 up = std::abs(way.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 axis = glm::normalize(up - glm::dot(up, way) * way);
  const glm::dvec3 side = glm::cross(axis, way);
  std::vector<LightSpace> lights = {light};
  for (int k = 1; k <= settings.steps; ++k) {
    const double angle = glm::radians(static_cast<double>(settings.degrees)) * k;
    const glm::vec3 turned = std::cos(angle) * way + std::sin(angle) * side;
    lights.push_back(light.atPoint() ? makePointLightSpace(light.pivot - turned / light.curvature,
                                                           light.pivot, light.origin)
                                     : makeLightSpace(turned, light.origin));
  }
  return lights;
}

Flicker flickerOf(std::span<const LightSpace> lights, std::size_t pointCount,
                  const std::function<void(const LightSpace&, std::span<float>)>& transmittance) {
  require(lights.size() >= 3, "flicker: ", lights.size(), " lights, needs at least 3");
  const std::size_t n = lights.size();
  std::vector<float> frames(n * pointCount);
  for (std::size_t k = 0; k < n; ++k)
    transmittance(lights[k], std::span(frames).subspan(k * pointCount, pointCount));

  // Measure each point against its regression line (swim) and by second differences (shimmer).
  const double middle = 0.5 * static_cast<double>(n - 1);
  double squares = 0;  // of the steps about their middle
  for (std::size_t k = 0; k < n; ++k) {
    const double x = static_cast<double>(k) - middle;
    squares += x * x;
  }
  double shimmer = 0, swim = 0;
  for (std::size_t p = 0; p < pointCount; ++p) {
    const auto at = [&](std::size_t k) { return static_cast<double>(frames[k * pointCount + p]); };
    double mean = 0, slope = 0;
    for (std::size_t k = 0; k < n; ++k) {
      // Relative to the first, so that constant values give exactly 0.
      mean += (at(k) - at(0)) / static_cast<double>(n);
      slope += (at(k) - at(0)) * (static_cast<double>(k) - middle) / squares;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double line = mean + slope * (static_cast<double>(k) - middle);
      swim += (at(k) - at(0) - line) * (at(k) - at(0) - line);
    }
    for (std::size_t k = 1; k + 1 < n; ++k) {
      const double bend = at(k - 1) - 2 * at(k) + at(k + 1);
      shimmer += bend * bend / 6;
    }
  }
  const double perPoint =
      std::max(static_cast<double>(pointCount), 1.0) * static_cast<double>(n - 2);
  return {std::sqrt(shimmer / perPoint), std::sqrt(swim / perPoint)};
}

Flicker flickerOf(const ShadowSettings& settings, StrandView strands, const Fibre& fibre,
                  std::span<const LightSpace> lights, std::span<const SamplePoint> points) {
  const std::unique_ptr<ShadowMethod> method = makeShadowMethod(settings);
  std::vector<float> all(strands.pointCount());
  return flickerOf(lights, points.size(), [&](const LightSpace& light, std::span<float> out) {
    method->build(strands, fibre, light);
    method->sampleStrands(strands, all);
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = all[points[i].point];
  });
}

Flicker flickerOf(const FibreTracer& tracer, const Fibre& fibre, std::span<const LightSpace> lights,
                  std::span<const SamplePoint> points, const TruthSettings& settings) {
  return flickerOf(lights, points.size(), [&](const LightSpace& light, std::span<float> out) {
    const Truth truth = exactTransmittance(tracer, fibre, light, points, settings);
    std::copy(truth.transmittance.begin(), truth.transmittance.end(), out.begin());
  });
}

}  // namespace hair

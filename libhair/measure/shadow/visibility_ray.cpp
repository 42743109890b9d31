#include <libhair/measure/shadow/visibility_ray.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/core/transform.h>

namespace hair {

namespace {

constexpr std::size_t kLooks = 512;       // points looked at
constexpr std::size_t kCoarseSteps = 96;  // to find where the hair begins and ends
constexpr float kLit = 0.998f, kFalling = 0.002f;

// Where the light's ray through p enters and leaves the ball about the hair's box.
std::pair<glm::vec3, glm::vec3> chord(const Bounds& box, const LightSpace& light, glm::vec3 p) {
  const glm::vec3 way = light.directionAt(p);
  const float radius = 0.5f * glm::length(box.size()) + 1e-3f;
  const glm::vec3 offset = p - box.centre();
  const float along = glm::dot(offset, way);
  const float across2 = glm::dot(offset, offset) - along * along;
  const float half = std::sqrt(std::max(radius * radius - across2, 1e-6f));
  float from = -along - half;
  if (light.atPoint()) from = std::max(from, -glm::distance(p, light.position()) * 0.999f);
  return {p + from * way, p + (half - along) * way};
}

ShadowRay rayTo(const LightSpace& light, glm::vec3 origin) {
  if (!light.atPoint()) return {origin, -light.direction(), INFINITY, kNoStrand};
  return {origin, -light.directionAt(origin), glm::distance(origin, light.position()), kNoStrand};
}

std::vector<glm::vec3> evenly(glm::vec3 from, glm::vec3 to, std::size_t steps) {
  std::vector<glm::vec3> points;
  points.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i)
    points.push_back(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps - 1)));
  return points;
}

std::vector<float> truthAt(const FibreTracer& tracer, const Fibre& fibre, const LightSpace& light,
                           std::span<const glm::vec3> points, const TruthSettings& settings) {
  std::vector<SamplePoint> samples;
  for (const glm::vec3 p : points) samples.push_back({kNoStrand, 0, p});
  return exactTransmittance(tracer, fibre, light, samples, settings).transmittance;
}

}  // namespace

glm::vec3 thickOfHair(const FibreTracer& tracer, StrandView strands, const LightSpace& light,
                      std::span<const SamplePoint> points, float footprint) {
  require(!points.empty(), "visibility ray: no points to choose among");
  const Bounds box = bounds(strands.points);
  const std::size_t looks = std::min(points.size(), kLooks);
  // Nine rays a point: its own, and eight on a circle within the footprint.
  std::vector<std::size_t> looked;
  std::vector<ShadowRay> rays;
  for (std::size_t l = 0; l < looks; ++l) {
    looked.push_back(l * points.size() / looks);
    const glm::vec3 p = points[looked.back()].position;
    const glm::vec3 far = chord(box, light, p).second;
    const glm::vec3 y = anyNormal(light.directionAt(p)), z = glm::cross(light.directionAt(p), y);
    rays.push_back(rayTo(light, far));
    for (int k = 0; k < 8; ++k) {
      const float angle = 0.25f * glm::pi<float>() * static_cast<float>(k);
      const glm::vec3 across = std::cos(angle) * y + std::sin(angle) * z;
      rays.push_back(rayTo(light, far + 0.7f * footprint * across));
    }
  }
  std::vector<std::uint32_t> counts(rays.size());
  tracer.countCrossings(rays, counts);
  std::vector<std::uint32_t> sums(looks);
  for (std::size_t r = 0; r < rays.size(); ++r) sums[r / 9] += counts[r];
  std::vector<std::size_t> order(looks);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sums[a] < sums[b]; });
  return points[looked[order[(looks - 1) * 9 / 10]]].position;
}

VisibilityRay makeVisibilityRay(const FibreTracer& tracer, StrandView strands, const Fibre& fibre,
                                const LightSpace& light, glm::vec3 through, std::size_t steps,
                                const TruthSettings& settings) {
  require(steps >= 2, "visibility ray: ", steps, " steps, needs at least 2");
  auto [from, to] = chord(bounds(strands.points), light, through);
  const std::vector<glm::vec3> coarse = evenly(from, to, kCoarseSteps);
  const std::vector<float> rough = truthAt(tracer, fibre, light, coarse, settings);
  std::size_t first = 0, last = kCoarseSteps - 1;
  while (first + 1 < kCoarseSteps && rough[first + 1] >= kLit) ++first;
  while (last > first + 1 && rough[last - 1] - rough.back() < kFalling) --last;
  const std::size_t margin = std::max<std::size_t>((last - first) / 20, 1);
  from = coarse[first - std::min(first, margin)];
  to = coarse[std::min(last + margin, kCoarseSteps - 1)];

  VisibilityRay ray;
  ray.points = evenly(from, to, steps);
  for (const glm::vec3 p : ray.points) ray.depth.push_back(glm::distance(p, from));
  ray.truth = truthAt(tracer, fibre, light, ray.points, settings);
  return ray;
}

}  // namespace hair

#include <libhair/measure/shadow/truth.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/core/transform.h>

namespace hair {

namespace {

// Random streams.
enum Use : std::uint32_t { kStrandOrder = 1, kPointOrder, kRadius, kAngle };

std::uint32_t hashOf(std::uint32_t item, Use use, std::uint32_t seed) {
  return hashWord(item ^ hashWord(use ^ hashWord(seed)));
}

/// Origin of ray i of n in the unit disc: Vogel's spiral, which spreads points evenly (equal areas,
/// golden angle), shifted along its radii and rotated by two random numbers, so that each ray alone
/// is uniform in the disc and the mean over the rays is unbiased.
glm::vec2 placeInDisc(std::uint32_t i, std::uint32_t n, double shift, double turn) {
  constexpr double kGoldenTurn = 0.38196601125010515, kTwoPi = 6.283185307179586;
  const double radius = std::sqrt((i + shift) / n);
  const double turns = i * kGoldenTurn + turn;
  const double angle = kTwoPi * (turns - std::floor(turns));
  return {static_cast<float>(radius * std::cos(angle)),
          static_cast<float>(radius * std::sin(angle))};
}

/// From `origin` towards the light.
ShadowRay rayToLight(const LightSpace& light, glm::vec3 origin, std::uint32_t strand) {
  ShadowRay ray{origin, -light.directionAt(origin), INFINITY, strand};
  if (light.atPoint()) ray.length = glm::distance(light.position(), origin);
  return ray;
}

}  // namespace

std::vector<SamplePoint> chooseSamplePoints(StrandView strands, std::size_t count,
                                            std::uint32_t seed) {
  validate(strands, "strands to sample", 0);
  // Order all points but roots: first a random one of each strand, strands in random order, then a
  // second one of each, and so on.
  struct Candidate {
    std::uint32_t round, strandOrder, strand, point;
  };
  std::vector<Candidate> candidates;
  candidates.reserve(strands.pointCount());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  for (std::uint32_t s = 0; s < strands.strandCount(); ++s) {
    order.clear();
    for (std::uint32_t p = strands.first[s] + 1; p < strands.first[s + 1]; ++p)
      order.emplace_back(hashOf(p, kPointOrder, seed), p);
    std::sort(order.begin(), order.end());
    for (std::uint32_t round = 0; round < order.size(); ++round)
      candidates.push_back({round, hashOf(s, kStrandOrder, seed), s, order[round].second});
  }
  count = std::min(count, candidates.size());
  std::nth_element(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                   candidates.end(), [](const Candidate& a, const Candidate& b) {
                     return std::tie(a.round, a.strandOrder, a.strand) <
                            std::tie(b.round, b.strandOrder, b.strand);
                   });
  std::vector<SamplePoint> points(count);
  for (std::size_t i = 0; i < count; ++i)
    points[i] = {candidates[i].strand, candidates[i].point, strands.points[candidates[i].point]};
  // Sort the chosen points as in memory, where neighbours of the hair are near each other.
  std::sort(points.begin(), points.end(),
            [](const SamplePoint& a, const SamplePoint& b) { return a.point < b.point; });
  return points;
}

Truth exactTransmittance(const FibreTracer& tracer, const Fibre& fibre, const LightSpace& light,
                         std::span<const SamplePoint> points, const TruthSettings& settings) {
  require(settings.footprint >= 0 && settings.footprint < 1e6f, "truth: footprint ",
          settings.footprint, " m is not in 0 to 1e6; set the footprint");
  constexpr std::uint32_t kMostRays = 1u << 22;
  require(settings.rays >= 2 && settings.rays <= kMostRays, "truth: ", settings.rays,
          " rays a point is not in 2 to ", kMostRays, "; set the rays");
  require(fibre.opacity >= 0 && fibre.opacity <= 1, "truth: a fibre's opacity of ", fibre.opacity,
          " is not in 0 to 1; set the opacity");
  // Trace one ray where the disc is a point.
  const std::uint32_t n = settings.footprint > 0 ? settings.rays : 1;
  // Tabulate the light that is left behind k fibres.
  std::vector<double> left;
  double rest = 1;
  for (int k = 0; k < 4096 && rest > 1e-30; ++k, rest *= 1.0 - static_cast<double>(fibre.opacity))
    left.push_back(rest);
  const auto leftBehind = [&](std::uint32_t k) {
    return k < left.size() ? left[k] : std::pow(1.0 - static_cast<double>(fibre.opacity), k);
  };

  Truth truth;
  truth.transmittance.resize(points.size());
  truth.standardError.resize(points.size());
  // Trace in batches of points that have a million rays together, or in single points.
  const std::size_t batch = std::max<std::size_t>(1, (1u << 20) / n);
  std::vector<ShadowRay> rays(std::min(points.size(), batch) * n);
  std::vector<std::uint32_t> crossings(rays.size());
  for (std::size_t first = 0; first < points.size(); first += batch) {
    const std::size_t count = std::min(batch, points.size() - first);
    // Make the rays.
    parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const SamplePoint& at = points[first + k];
        const glm::vec3 across = anyNormal(light.directionAt(at.position));
        const glm::vec3 up = glm::cross(light.directionAt(at.position), across);
        const double shift = static_cast<double>(uniform(at.point, kRadius, settings.seed));
        const double turn = static_cast<double>(uniform(at.point, kAngle, settings.seed));
        for (std::uint32_t i = 0; i < n; ++i) {
          const glm::vec2 d = settings.footprint * placeInDisc(i, n, shift, turn);
          rays[k * n + i] = rayToLight(light, at.position + d.x * across + d.y * up, at.strand);
        }
      }
    });
    tracer.countCrossings(std::span(rays).first(count * n), std::span(crossings).first(count * n));
    parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        // Find mean and variance relative to the first ray, so that equal rays have no variance.
        const std::uint32_t* const crossed = &crossings[k * n];
        const double start = leftBehind(crossed[0]);
        double sum = 0, squares = 0;
        for (std::uint32_t i = 0; i < n; ++i) sum += leftBehind(crossed[i]) - start;
        const double mean = start + sum / n;
        for (std::uint32_t i = 0; i < n; ++i) {
          const double off = leftBehind(crossed[i]) - mean;
          squares += off * off;
        }
        truth.transmittance[first + k] = static_cast<float>(mean);
        truth.standardError[first + k] =
            n > 1 ? static_cast<float>(std::sqrt(squares / (n - 1.0) / n)) : 0.0f;
      }
    });
  }
  return truth;
}

}  // namespace hair

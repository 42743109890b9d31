#include <algorithm>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/model/head.h>
#include <libhair/model/scalp_roots.h>

namespace hair {
namespace {

constexpr double kCrownDensity = 0.3;  // 1.4 times the mean there, 0.8 times at the sides

enum Use : std::uint16_t { JitterAlong = 0x100, JitterAcross, Thin, FirstCentre };

// Distances between cells are measured with both sides of the parting moved apart, so that no cell
// spans it.
glm::vec3 pulledApart(const Parting& parting, glm::vec3 p) {
  const float ahead = glm::smoothstep(parting.whorlZ - 0.01f, parting.whorlZ + 0.015f, p.z);
  const float top = glm::smoothstep(0.12f, 0.15f, p.y);
  p.x += (p.x > parting.x ? 0.06f : -0.06f) * ahead * top;
  return p;
}

std::uint32_t nearestTo(glm::vec3 p, std::span<const glm::vec3> centres) {
  std::uint32_t best = 0;
  float bestSquared = INFINITY;
  for (std::uint32_t c = 0; c < centres.size(); ++c) {
    const glm::vec3 d = p - centres[c];
    const float squared = glm::dot(d, d);
    if (squared < bestSquared) best = c, bestSquared = squared;
  }
  return best;
}

// March inwards from outside: the first hit, so that ears and neck do not count.
template <class Distance>
glm::vec3 firstHit(glm::vec3 ray, float tolerance, const Distance& distance) {
  float t = 0.13f;
  for (int step = 0; step < 40; ++step) {
    const float d = distance(kSkullMiddle + t * ray);
    t -= 0.9f * d;
    if (std::abs(d) < tolerance) break;
  }
  return kSkullMiddle + t * ray;
}

}  // namespace

glm::vec3 awayFromParting(const Parting& parting, glm::vec3 p) {
  glm::vec3 away(p.x - parting.x, 0, std::min(p.z - parting.whorlZ, 0.0f));
  const float length = glm::length(away);
  return length > 1e-6f ? away / length : glm::vec3(1, 0, 0);
}

glm::vec3 onScalp(const MeshSdf& headSdf, glm::vec3 p) {
  return firstHit(glm::normalize(p - kSkullMiddle), 1e-5f,
                  [&](glm::vec3 q) { return headSdf.distance(q); });
}

glm::vec3 onScalp(glm::vec3 p) {
  return firstHit(glm::normalize(p - kSkullMiddle), 1e-6f, headField);
}

std::vector<glm::vec3> scalpRoots(const MeshSdf& headSdf, std::uint32_t count, std::uint32_t seed) {
  // Lattice of n directions; index i spirals from the crown downwards.
  const auto onHead = [&](std::uint32_t i, std::uint32_t n) {
    const float spacing = 3.5f / std::sqrt(static_cast<float>(n));  // radians
    // Denser towards the crown, whose hair lies on top and is most visible.
    const double x = (i + 0.5) / n;
    const double up =
        1 - 2 * (x - kCrownDensity * std::sin(2 * std::numbers::pi * x) / (2 * std::numbers::pi));
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const double across = std::sqrt(1 - up * up);
    glm::vec3 ray(across * std::cos(turn), up, across * std::sin(turn));
    const float j = 0.35f * spacing;
    const glm::vec3 u = glm::normalize(glm::cross(ray, glm::vec3(0.3f, 0.1f, 0.9f)));
    ray += j * (2 * uniform(i, JitterAlong, seed) - 1) * u +
           j * (2 * uniform(i, JitterAcross, seed) - 1) * glm::cross(ray, u);
    return onScalp(headSdf, kSkullMiddle + 0.05f * glm::normalize(ray));
  };
  const auto onScalpOf = [&](std::uint32_t n) {
    std::vector<glm::vec3> points(n);
    parallelFor(n, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const glm::vec3 p = onHead(static_cast<std::uint32_t>(i), n);
        points[i] = scalpMask(p) > 0.5f ? p : glm::vec3(NAN);
      }
    });
    std::erase_if(points, [](glm::vec3 p) { return std::isnan(p.x); });
    return points;
  };
  const double share = static_cast<double>(onScalpOf(4096).size()) / 4096;
  require(share > 0, "scalp roots: the head has no scalp where the built-in head has it");
  std::uint32_t n = static_cast<std::uint32_t>(1.01 * count / share) + 16;
  std::vector<glm::vec3> roots = onScalpOf(n);
  while (roots.size() < count) roots = onScalpOf(n += 1 + n / 64);
  // Drop the surplus, evenly along the spiral.
  std::vector<glm::vec3> chosen(count);
  for (std::size_t i = 0; i < count; ++i) chosen[i] = roots[i * roots.size() / count];
  return chosen;
}

WispCells wispCells(const MeshSdf& headSdf, std::span<const glm::vec3> roots,
                    std::uint32_t wispCount, const Parting& parting, std::uint32_t seed) {
  require(wispCount > 0 && roots.size() >= wispCount, "wisp cells: ", roots.size(),
          " strands cannot fill ", wispCount, " wisps; draw more strands or take fewer wisps");
  const auto samples = scalpRoots(headSdf, std::max(16 * wispCount, 1024u), seed);
  std::vector<glm::vec3> apart(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) apart[i] = pulledApart(parting, samples[i]);

  // Lloyd's iteration from an even choice of samples.
  std::vector<glm::vec3> centres(wispCount);
  for (std::uint32_t w = 0; w < wispCount; ++w) {
    const float at = (static_cast<float>(w) + uniform(w, FirstCentre, seed)) *
                     static_cast<float>(apart.size()) / static_cast<float>(wispCount);
    centres[w] = apart[std::min(static_cast<std::size_t>(at), apart.size() - 1)];
  }
  std::vector<std::uint32_t> cell(samples.size());
  for (int iteration = 0; iteration < 24; ++iteration) {
    std::vector<glm::vec4> sum(wispCount, glm::vec4(0));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      cell[i] = nearestTo(apart[i], centres);
      sum[cell[i]] += glm::vec4(apart[i], 1);
    }
    for (std::uint32_t w = 0; w < wispCount; ++w)
      if (sum[w].w > 0) centres[w] = glm::vec3(sum[w]) / sum[w].w;
  }

  WispCells cells;
  cells.wisp.resize(roots.size());
  parallelFor(roots.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells.wisp[i] = nearestTo(pulledApart(parting, roots[i]), centres);
  });
  // Project back to the head: the mean of a cell's samples, at their original positions.
  std::vector<glm::vec4> sum(wispCount, glm::vec4(0));
  for (std::size_t i = 0; i < samples.size(); ++i) sum[cell[i]] += glm::vec4(samples[i], 1);
  for (std::uint32_t w = 0; w < wispCount; ++w)
    cells.centres.push_back(
        onScalp(headSdf, sum[w].w > 0 ? glm::vec3(sum[w]) / sum[w].w : centres[w]));
  return cells;
}

}  // namespace hair

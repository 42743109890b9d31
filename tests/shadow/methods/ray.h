#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <libhair/core/random.h>
#include <libhair/shadow/methods/density_clustering.h>

namespace hair::test {

/// Figure 5 of Mertens et al. 2004: fragments along one ray, from 0 to 1, drawn from `gaussians`
/// normal distributions of random mean and width; front to back. Together they have `opticalDepth`.
inline std::vector<PixelFragment> fragmentsOfGaussians(int gaussians, std::uint32_t seed,
                                                       int count = 100, float opticalDepth = 4) {
  std::vector<PixelFragment> fragments;
  for (std::uint32_t i = 0; fragments.size() < static_cast<std::size_t>(count); ++i) {
    const std::uint32_t g = i % static_cast<std::uint32_t>(gaussians);
    const float mean = uniform(g, 1, seed), width = 0.01f + 0.04f * uniform(g, 2, seed);
    const float radius = std::sqrt(-2 * std::log(1 - uniform(i, 3, seed)));
    const float depth = mean + width * radius * std::cos(6.2831853f * uniform(i, 4, seed));
    // The weights differ too.
    if (depth > 0 && depth < 1) fragments.push_back({depth, 0.5f + uniform(i, 5, seed)});
  }
  std::sort(fragments.begin(), fragments.end(),
            [](const PixelFragment& a, const PixelFragment& b) { return a.depth < b.depth; });
  float sum = 0;
  for (const PixelFragment& f : fragments) sum += f.opticalDepth;
  for (PixelFragment& f : fragments) f.opticalDepth *= opticalDepth / sum;
  return fragments;
}

/// The product as it stands.
inline float exactTransmittance(const std::vector<PixelFragment>& fragments, float depth) {
  double product = 1;
  for (const PixelFragment& f : fragments)
    if (f.depth < depth) product *= std::exp(-double{f.opticalDepth});
  return static_cast<float>(product);
}

/// Even bins between the first and the last fragment: section 3.2, "the histogram method".
inline std::vector<DepthBin> uniformHistogram(const std::vector<PixelFragment>& fragments,
                                              int count) {
  const float from = fragments.front().depth, to = fragments.back().depth;
  const float step = (to - from) / static_cast<float>(count);
  std::vector<DepthBin> bins;
  for (int b = 0; b < count; ++b)
    bins.push_back(
        {from + step * static_cast<float>(b), from + step * static_cast<float>(b + 1), 0});
  for (const PixelFragment& f : fragments)
    bins[std::min(static_cast<std::size_t>((f.depth - from) / step), bins.size() - 1)]
        .opticalDepth += f.opticalDepth;
  return bins;
}

inline std::vector<DepthBin> clustered(const std::vector<PixelFragment>& fragments,
                                       const DensityClusteringSettings& settings,
                                       float leastWidth = 0) {
  std::vector<DepthBin> bins(static_cast<std::size_t>(settings.clusters));
  bins.resize(clusterFragments(fragments, settings, leastWidth, bins));
  return bins;
}

/// Mean over [0, until] of |exp(-bins) - exact|.
inline double meanError(const std::vector<DepthBin>& bins,
                        const std::vector<PixelFragment>& fragments, float until = 1) {
  double sum = 0;
  for (int i = 0; i < 500; ++i) {
    const float s = until * (static_cast<float>(i) + 0.5f) / 500;
    sum += std::abs(double{std::exp(-opticalDepthAt(bins, s))} -
                    double{exactTransmittance(fragments, s)});
  }
  return sum / 500;
}

}  // namespace hair::test

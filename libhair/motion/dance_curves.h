#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/motion/dance_score.h>

namespace hair::score {

constexpr std::size_t kFrames = 1800;  ///< of one loop of the dance, 120 a second

using Curve = std::vector<float>;  ///< [kFrames], one loop

inline double beatOf(std::size_t frame) {
  return static_cast<double>(frame) * kBeats / kFrames;
}

/// Monotone cubic through the keys (Fritsch and Carlson 1980, harmonic mean of slopes), periodic;
/// each loop adds `gain`.
template <class Keys, class Value>
Curve throughKeys(const Keys& keys, const Value& value, float gain) {
  if (keys.empty()) return Curve(kFrames);
  const auto count = static_cast<std::ptrdiff_t>(keys.size());
  const auto at = [&](std::ptrdiff_t k) {
    const std::ptrdiff_t round = k < 0 ? -1 : k / count;
    const auto& key = keys[static_cast<std::size_t>(k - round * count)];
    return glm::dvec2(key.beat + kBeats * static_cast<double>(round),
                      value(key) + gain * static_cast<float>(round));
  };
  const auto slope = [&](std::ptrdiff_t k) {
    const glm::dvec2 a = at(k) - at(k - 1), b = at(k + 1) - at(k);
    const double sa = a.y / a.x, sb = b.y / b.x;
    return sa * sb <= 0 ? 0.0 : 2.0 * sa * sb / (sa + sb);
  };
  Curve curve(kFrames);
  std::ptrdiff_t k = 0;  // the keys around a frame: k, k + 1
  for (std::size_t f = 0; f < kFrames; ++f) {
    const double beat = beatOf(f);
    while (k + 1 < count && at(k + 1).x <= beat) ++k;
    while (at(k).x > beat) --k;
    const glm::dvec2 a = at(k), b = at(k + 1);
    const double h = b.x - a.x, t = (beat - a.x) / h, u = 1.0 - t;
    curve[f] = static_cast<float>(u * u * (1.0 + 2.0 * t) * a.y + t * t * (3.0 - 2.0 * t) * b.y +
                                  h * t * u * (u * slope(k) - t * slope(k + 1)));
  }
  return curve;
}

/// Mean over ±`reach` frames, weights (1 + cos), periodic; each loop adds `gain`.
inline Curve smoothed(const Curve& in, float gain = 0.0f, int reach = 11) {
  Curve out(kFrames);
  for (std::size_t f = 0; f < kFrames; ++f) {
    double sum = 0, weights = 0;
    for (int d = -reach; d <= reach; ++d) {
      const double w =
          1.0 + std::cos(3.14159265f * static_cast<float>(d) / static_cast<float>(reach + 1));
      const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(f) + d;
      constexpr auto n = static_cast<std::ptrdiff_t>(kFrames);
      const std::ptrdiff_t round = i < 0 ? -1 : i / n;
      sum += w * (in[static_cast<std::size_t>(i - round * n)] + gain * static_cast<float>(round));
      weights += w;
    }
    out[f] = static_cast<float>(sum / weights);
  }
  return out;
}

}  // namespace hair::score

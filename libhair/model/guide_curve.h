#pragma once

#include <algorithm>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/transform.h>

namespace hair {

/// Where a guide's curve and frame are sampled: between its points `link` and `link` + 1.
struct CurvePlace {
  std::size_t link;
  float t;  ///< [0, 1]
};

/// Of drawn point k of n, on a guide of `pointsPerGuide` points: even in the parameter, root to
/// tip.
inline CurvePlace curvePlace(std::size_t k, std::size_t n, std::size_t pointsPerGuide) {
  const float u = n > 1 ? static_cast<float>(k) * static_cast<float>(pointsPerGuide - 1) /
                              static_cast<float>(n - 1)
                        : 0.0f;
  const std::size_t link = std::min(static_cast<std::size_t>(u), pointsPerGuide - 2);
  return {link, u - static_cast<float>(link)};
}

/// Uniform Catmull-Rom curve through a guide's points; beyond its ends the guide goes on straight
/// (P[-1] = 2 P[0] - P[1]).
inline glm::vec3 curvePoint(std::span<const glm::vec3> p, CurvePlace at) {
  const std::size_t i = at.link;
  const float t = at.t;
  const glm::vec3 a = i > 0 ? p[i - 1] : 2.0f * p[0] - p[1];
  const glm::vec3 d = i + 2 < p.size() ? p[i + 2] : 2.0f * p[i + 1] - p[i];
  const glm::vec3 b = p[i], c = p[i + 1];
  return b + 0.5f * t *
                 (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
}

/// Columns (normal, binormal, tangent) at each of a guide's points. The tangent is that of the
/// Catmull-Rom curve (central difference; one-sided at the ends). The root's normal comes with
/// the head; from there the frame is carried by parallel transport from point to point.
///
/// At rest in head space, `rootNormal` is restRootNormal(points). In motion it is that same vector
/// turned by the head's rotation.
inline void guideFrames(std::span<const glm::vec3> p, glm::vec3 rootNormal,
                        std::span<glm::mat3> frames) {
  const auto tangent = [&](std::size_t i) {
    const glm::vec3 d = p[std::min(i + 1, p.size() - 1)] - p[i > 0 ? i - 1 : 0];
    const float length = glm::length(d);
    return length > 0 ? d / length : glm::vec3(0, -1, 0);
  };
  glm::vec3 t = tangent(0);
  // The head's normal may be off by what the first link has bent since the rest shape.
  glm::vec3 n = rootNormal - glm::dot(rootNormal, t) * t;
  const float length = glm::length(n);
  n = length > 1e-6f ? n / length : anyNormal(t);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::vec3 next = tangent(i);
    n = transport(n, t, next);
    t = next;
    frames[i] = glm::mat3(n, glm::cross(t, n), t);
  }
}

inline glm::vec3 restRootNormal(std::span<const glm::vec3> p) {
  return anyNormal(glm::normalize(p[1] - p[0]));
}

/// The frame between two points of a guide: the linear blend of theirs. It is a little short
/// where the guide bends sharply, which costs nothing and is what `Groom::offsets` is baked with.
inline glm::mat3 curveFrame(std::span<const glm::mat3> frames, CurvePlace at) {
  return (1 - at.t) * frames[at.link] + at.t * frames[at.link + 1];
}

}  // namespace hair

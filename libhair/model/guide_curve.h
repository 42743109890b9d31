#pragma once

#include <algorithm>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/transform.h>

namespace hair {

/// A guide at rest as a curve: uniform Catmull-Rom through its points (beyond its ends it goes on
/// straight, P[-1] = 2 P[0] - P[1]), `curve.size()` samples evenly in the parameter, root and tip
/// included. What drawn strands are made of (Groom); this is the plain form of it, for one guide,
/// that grooms are baked with.
inline void sampleGuide(std::span<const glm::vec3> guide, std::span<glm::vec3> curve) {
  const std::size_t n = guide.size(), samples = curve.size();
  for (std::size_t k = 0; k < samples; ++k) {
    const float u = samples > 1 ? static_cast<float>(k) * static_cast<float>(n - 1) /
                                      static_cast<float>(samples - 1)
                                : 0.0f;
    const std::size_t i = std::min(static_cast<std::size_t>(u), n - 2);
    const float t = u - static_cast<float>(i);
    const glm::vec3 b = guide[i], c = guide[i + 1];
    const glm::vec3 a = i > 0 ? guide[i - 1] : 2.0f * b - c;
    const glm::vec3 d = i + 2 < n ? guide[i + 2] : 2.0f * c - b;
    curve[k] =
        b + 0.5f * t *
                (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
  }
}

/// Frames, as columns (normal, binormal, tangent), at the samples of a guide's curve at rest.
/// The tangent is the chord between the samples before and after; the normal starts as
/// anyNormal(direction of the first link) and is carried from sample to sample by parallel
/// transport.
inline void sampleGuideFrames(std::span<const glm::vec3> guide, std::span<const glm::vec3> curve,
                              std::span<glm::mat3> frames) {
  const auto direction = [](glm::vec3 d) {
    const float length = glm::length(d);
    return length > 0 ? d / length : glm::vec3(0, 1, 0);
  };
  glm::vec3 tangent = direction(guide[1] - guide[0]);
  glm::vec3 normal = anyNormal(tangent);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const glm::vec3 next =
        direction(curve[std::min(k + 1, curve.size() - 1)] - curve[k > 0 ? k - 1 : 0]);
    normal = transport(normal, tangent, next);
    normal = glm::normalize(normal - glm::dot(normal, next) * next);
    tangent = next;
    frames[k] = glm::mat3(normal, glm::cross(tangent, normal), tangent);
  }
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/transform.h>

namespace hair {

/// d as a unit vector; `otherwise` if it has no length.
inline glm::vec3 directionOr(glm::vec3 d, glm::vec3 otherwise) {
  const float length = glm::length(d);
  return length > 0 ? d / length : otherwise;
}

/// Point i + t, t in [0, 1], of the uniform Catmull-Rom curve through two points or more; beyond
/// its ends it goes on straight, P[-1] = 2 P[0] - P[1].
inline glm::vec3 catmullRom(std::span<const glm::vec3> p, std::size_t i, float t) {
  const glm::vec3 b = p[i], c = p[i + 1];
  const glm::vec3 a = i > 0 ? p[i - 1] : 2.0f * b - c;
  const glm::vec3 d = i + 2 < p.size() ? p[i + 2] : 2.0f * c - b;
  return b + 0.5f * t *
                 (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
}

/// A guide at rest as a curve: `curve.size()` samples of catmullRom evenly in the parameter, root
/// and tip included. Drawn strands are sums of these (Groom); this is the scalar form, for one
/// guide, with which grooms are made.
inline void sampleGuide(std::span<const glm::vec3> guide, std::span<glm::vec3> curve) {
  const std::size_t n = guide.size(), samples = curve.size();
  for (std::size_t k = 0; k < samples; ++k) {
    const float u = samples > 1 ? static_cast<float>(k) * static_cast<float>(n - 1) /
                                      static_cast<float>(samples - 1)
                                : 0.0f;
    const std::size_t i = std::min(static_cast<std::size_t>(u), n - 2);
    curve[k] = catmullRom(guide, i, u - static_cast<float>(i));
  }
}

/// Frames, as columns (normal, binormal, tangent), at the points of a curve: the normal, at a right
/// angle to the unit tangent there, is carried to the first point and from point to point by
/// parallel transport. The tangent of a point is the chord between the points before and after.
inline void transportFrames(glm::vec3 tangent, glm::vec3 normal, std::span<const glm::vec3> curve,
                            std::span<glm::mat3> frames) {
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const glm::vec3 next =
        directionOr(curve[std::min(k + 1, curve.size() - 1)] - curve[k > 0 ? k - 1 : 0], {0, 1, 0});
    normal = transport(normal, tangent, next);
    normal = glm::normalize(normal - glm::dot(normal, next) * next);
    tangent = next;
    frames[k] = glm::mat3(normal, glm::cross(tangent, normal), tangent);
  }
}

/// Those at the samples of a guide's curve at rest. The normal starts as anyNormal(direction of the
/// first link).
inline void sampleGuideFrames(std::span<const glm::vec3> guide, std::span<const glm::vec3> curve,
                              std::span<glm::mat3> frames) {
  const glm::vec3 tangent = directionOr(guide[1] - guide[0], {0, 1, 0});
  transportFrames(tangent, anyNormal(tangent), curve, frames);
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <array>

#include <glm/glm.hpp>

namespace hair {

using TriangleCorners = std::array<glm::vec3, 3>;

/// Squared distance to a triangle (Ericson 2005, "Real-Time Collision Detection", section 5.1.5).
inline float squaredDistance(glm::vec3 p, const TriangleCorners& t) {
  const glm::vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const auto from = [&](glm::vec3 q) {
    const glm::vec3 d = p - q;
    return glm::dot(d, d);
  };
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return from(t[0]);
  const glm::vec3 bp = p - t[1];
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return from(t[1]);
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return from(t[0] + d1 / (d1 - d3) * ab);
  const glm::vec3 cp = p - t[2];
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return from(t[2]);
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return from(t[0] + d2 / (d2 - d6) * ac);
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return from(t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]));
  const float sum = va + vb + vc;
  if (!(sum > 0)) return std::min({from(t[0]), from(t[1]), from(t[2])});
  return from(t[0] + (vb / sum) * ab + (vc / sum) * ac);
}

/// A lower bound of it that is cheap: squared distance to the triangle's box.
inline float squaredBoxDistance(glm::vec3 p, const TriangleCorners& t) {
  const glm::vec3 lower = glm::min(t[0], glm::min(t[1], t[2])),
                  upper = glm::max(t[0], glm::max(t[1], t[2])),
                  d = glm::max(glm::max(lower - p, p - upper), 0.0f);
  return glm::dot(d, d);
}

}  // namespace hair

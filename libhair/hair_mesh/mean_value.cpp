#include <libhair/hair_mesh/mean_value.h>

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// tan of half the angle between a and b of lengths la and lb, by the form that does not cancel.
double tanHalf(glm::dvec2 a, glm::dvec2 b, double la, double lb) {
  const double sine = cross(a, b), cosine = glm::dot(a, b);  // both times la lb
  return cosine >= 0 ? sine / (la * lb + cosine) : (la * lb - cosine) / sine;
}

}  // namespace

FlatPolygon::FlatPolygon(std::span<const glm::vec3> polygon) : origin(0), corners(polygon.size()) {
  const std::size_t n = polygon.size();
  for (const glm::vec3 p : polygon) origin += glm::dvec3(p) / static_cast<double>(n);
  glm::dvec3 newell(0);
  double extent = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 a = glm::dvec3(polygon[i]) - origin;
    newell += 0.5 * glm::cross(a, glm::dvec3(polygon[(i + 1) % n]) - origin);
    extent = std::max(extent, glm::dot(a, a));
  }
  const double newellArea = glm::length(newell);
  if (!(newellArea > 1e-9 * extent)) return;  // corners in one line, to float precision
  area = newellArea;
  normal = newell / area;
  for (std::size_t i = 0; i < n; ++i) {
    const auto edge = glm::dvec3(polygon[(i + 1) % n]) - glm::dvec3(polygon[i]);
    const glm::dvec3 flat = edge - glm::dot(edge, normal) * normal;
    const double length = glm::length(flat);
    if (length * length <= 1e-12 * extent) continue;
    u = flat / length;
    v = glm::cross(normal, u);
    break;
  }
  for (std::size_t i = 0; i < n; ++i) corners[i] = project(polygon[i]);
}

glm::dvec2 FlatPolygon::project(glm::dvec3 p) const {
  return {glm::dot(p - origin, u), glm::dot(p - origin, v)};
}

bool FlatPolygon::contains(glm::dvec2 p) const {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const glm::dvec2 a = corners[j], b = corners[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

void meanValueCoordinates(std::span<const glm::dvec2> polygon, glm::dvec2 p,
                          std::span<float> weights) {
  const std::size_t n = polygon.size();
  std::ranges::fill(weights, 0.0f);
  double extent = 0;
  for (const glm::dvec2 q : polygon) extent = std::max(extent, glm::dot(q - p, q - p));
  const double near = 1e-12 * std::sqrt(extent);

  // On a corner or an edge the formula divides zero by zero; its limit is linear there.
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const glm::dvec2 a = polygon[i] - p, b = polygon[j] - p;
    const double la = glm::length(a), lb = glm::length(b), length = glm::distance(a, b);
    if (la <= near) {
      weights[i] = 1;
      return;
    }
    if (lb > near && glm::dot(a, b) < 0 && std::abs(cross(a, b)) <= near * length) {
      weights[i] = static_cast<float>(lb / (la + lb));
      weights[j] = static_cast<float>(la / (la + lb));
      return;
    }
  }

  const auto unscaled = [&](std::size_t i) {
    const glm::dvec2 a = polygon[(i + n - 1) % n] - p, b = polygon[i] - p,
                     c = polygon[(i + 1) % n] - p;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return (tanHalf(a, b, la, lb) + tanHalf(b, c, lb, lc)) / lb;
  };
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += unscaled(i);
  for (std::size_t i = 0; i < n; ++i) weights[i] = static_cast<float>(unscaled(i) / sum);
}

void meanValueCoordinates(std::span<const glm::vec3> polygon, glm::vec3 p,
                          std::span<float> weights) {
  const FlatPolygon flat(polygon);
  if (flat.area == 0) {
    std::ranges::fill(weights, 1.0f / static_cast<float>(polygon.size()));
    return;
  }
  meanValueCoordinates(flat.corners, flat.project(p), weights);
}

}  // namespace hair

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/measure/shadow/truth.h>

namespace hair {

/// What of the strands a tracer sees: points that differ from the one before them, strand after
/// strand. Segment i joins points i and i + 1 where both are of one strand.
struct RibbonPoints {
  std::vector<glm::vec3> points;      ///< metres
  std::vector<std::uint32_t> strand;  ///< [points.size()], as in the StrandView
  double halfWidth = 0;               ///< metres

  bool isSegment(std::size_t i) const {
    return i + 1 < points.size() && strand[i] == strand[i + 1];
  }
};

/// Throws Error for strands that are not valid and for a fibre out of range.
RibbonPoints makeRibbonPoints(StrandView strands, const Fibre& fibre);

/// Throws Error unless there is one output a ray, and every direction has a length.
void checkRays(std::span<const ShadowRay> rays, std::size_t outputs);

/// The axes that a ray sees things in; double, so that no other order of the same sums changes what
/// a ray crosses.
struct RayFrame {
  glm::dvec3 origin, right, up, along;
  double length;

  explicit RayFrame(const ShadowRay& ray) : origin(ray.origin), length(ray.length) {
    along = glm::normalize(glm::dvec3(ray.toLight));
    // As anyNormal() (core/transform.h).
    const double s = along.z < 0 ? -1.0 : 1.0;
    const double a = -1.0 / (s + along.z);
    right = {1.0 + s * along.x * along.x * a, s * along.x * along.y * a, -s * along.x};
    up = glm::cross(along, right);
  }
  /// Right, up and along of a point.
  glm::dvec3 see(glm::vec3 p) const {
    const glm::dvec3 d = glm::dvec3(p) - origin;
    return {glm::dot(d, right), glm::dot(d, up), glm::dot(d, along)};
  }
};

/// The law of ribbons: whether a crossing of the ray with its strand begins at segment i.
///
/// Seen along the ray, segment k is all that lies nearer to it than half the width: a bar that ends
/// in half discs, which fill the outer sides of bends. Where the strand begins and ends the bar is
/// cut square. The ray meets segment k if it goes through the bar, and the centre line at its foot
/// (the nearest point of the segment, as seen) lies in front of the origin and before the light.
/// Neighbours that the ray meets are one crossing: it counts where the first of them is. Hence a
/// strand is crossed once where it is crossed, be it bent as it may: mitres would do the same for
/// gentle bends, but grow without bound as the bend, seen along the ray, nears a half turn, as it
/// does wherever hair runs along the light. Only where the strand turns back by more than a right
/// angle, as seen, and the ray goes through both legs (not merely near the bend) are these two.
inline bool crossingBegins(const RibbonPoints& ribbons, std::size_t i, const RayFrame& ray) {
  struct Meeting {
    glm::dvec2 way;  // of the segment, as seen
    double foot;     // 0 to 1 inside of the segment
    bool met;
  };
  const auto& [points, strand, halfWidth] = ribbons;
  const auto meet = [&](glm::dvec3 a, glm::dvec3 b, bool first, bool last) {
    Meeting m{{b.x - a.x, b.y - a.y}, 0.5, false};
    const double square = glm::dot(m.way, m.way);
    // A segment that is seen from its end is a disc.
    if (square > 0) m.foot = -(a.x * m.way.x + a.y * m.way.y) / square;
    if ((first && m.foot < 0) || (last && m.foot > 1)) return m;
    const double t = std::clamp(m.foot, 0.0, 1.0);
    const double x = a.x + t * m.way.x, y = a.y + t * m.way.y, depth = a.z + t * (b.z - a.z);
    m.met = x * x + y * y < halfWidth * halfWidth && depth > 0 && depth < ray.length;
    return m;
  };
  const bool first = i == 0 || strand[i - 1] != strand[i];
  const bool last = i + 2 == points.size() || strand[i + 2] != strand[i];
  const glm::dvec3 a = ray.see(points[i]);
  const Meeting here = meet(a, ray.see(points[i + 1]), first, last);
  if (!here.met || first) return here.met;
  const Meeting before =
      meet(ray.see(points[i - 1]), a, i == 1 || strand[i - 2] != strand[i], false);
  if (!before.met) return true;
  return glm::dot(before.way, here.way) < 0 && before.foot < 1 && here.foot > 0;
}

}  // namespace hair

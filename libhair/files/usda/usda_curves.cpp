#include <libhair/files/usda/usda_curves.h>

#include <algorithm>

namespace hair {

namespace {

using Basis = UsdaCurveKind::Basis;
using Wrap = UsdaCurveKind::Wrap;

// Weights of four vertices at parameter t of their segment.
std::array<float, 4> weightsAt(Basis basis, float t) {
  const float u = 1 - t, t2 = t * t, t3 = t2 * t;
  switch (basis) {
    case Basis::Bezier:
      return {u * u * u, 3 * u * u * t, 3 * u * t2, t3};
    case Basis::BSpline:
      return {u * u * u / 6, (3 * t3 - 6 * t2 + 4) / 6, (-3 * t3 + 3 * t2 + 3 * t + 1) / 6, t3 / 6};
    case Basis::CatmullRom:
      return {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2,
              (t3 - t2) / 2};
    case Basis::Linear:
      break;
  }
  return {0, u, t, 0};
}

// What a kind comes down to for so few vertices.
UsdaCurveKind possible(UsdaCurveKind kind, std::uint32_t vertices) {
  // Its end vertices are on a Bézier curve anyway.
  if (kind.basis == Basis::Bezier && kind.wrap == Wrap::Pinned) kind.wrap = Wrap::Nonperiodic;
  if (kind.basis == Basis::Linear && kind.wrap == Wrap::Pinned) kind.wrap = Wrap::Nonperiodic;
  const std::uint32_t least = kind.basis == Basis::Linear      ? 0
                              : kind.wrap == Wrap::Nonperiodic ? 4
                              : kind.wrap == Wrap::Periodic    ? 3
                                                               : 2;
  if (vertices < least) return {};
  if (vertices < 3 && kind.wrap == Wrap::Periodic) return {};
  return kind;
}

// 0: no such curve.
std::uint32_t segmentsOf(UsdaCurveKind kind, std::uint32_t n) {
  if (kind.basis == Basis::Bezier) {
    if (kind.wrap == Wrap::Periodic) return n % 3 == 0 ? n / 3 : 0;
    return (n - 4) % 3 == 0 ? (n - 4) / 3 + 1 : 0;
  }
  if (kind.wrap == Wrap::Periodic) return n;
  return kind.wrap == Wrap::Pinned || kind.basis == Basis::Linear ? n - 1 : n - 3;
}

}  // namespace

std::uint32_t varyingOfCurve(UsdaCurveKind kind, std::uint32_t vertices) {
  if (vertices < 2) return vertices;
  kind = possible(kind, vertices);
  const std::uint32_t segments = segmentsOf(kind, vertices);
  return segments == 0 || kind.wrap == Wrap::Periodic ? segments : segments + 1;
}

std::vector<UsdaCurvePoint> pointsOfCurve(UsdaCurveKind kind, std::uint32_t n) {
  std::vector<UsdaCurvePoint> points;
  kind = possible(kind, n);
  if (kind == UsdaCurveKind{} || n < 2) {
    for (std::uint32_t v = 0; v < n; ++v) points.push_back({{v, v, v, v}, {1, 0, 0, 0}, v, v, 0});
    return points;
  }
  const std::uint32_t segments = segmentsOf(kind, n);
  if (segments == 0) return points;
  const std::uint32_t varying = varyingOfCurve(kind, n);
  const std::uint32_t least = kind.basis == Basis::Linear ? 1 : kind.basis == Basis::Bezier ? 4 : 2;
  const std::uint32_t steps =
      kind.basis == Basis::Linear ? 1 : std::max(least, (8 + segments - 1) / segments);
  const auto add = [&](std::uint32_t segment, float t) {
    UsdaCurvePoint point{{}, {}, segment % varying, (segment + 1) % varying, t};
    // The segment's first vertex; pinned curves and straight ones have one before the first.
    const std::int64_t first = kind.basis == Basis::Bezier ? std::int64_t{3} * segment
                               : kind.wrap == Wrap::Nonperiodic && kind.basis != Basis::Linear
                                   ? std::int64_t{segment}
                                   : std::int64_t{segment} - 1;
    const std::array<float, 4> weights = weightsAt(kind.basis, t);
    std::size_t used = 0;
    const auto weigh = [&](std::uint32_t vertex, float weight) {
      for (std::size_t k = 0; k < used; ++k)
        if (point.vertex[k] == vertex) {
          point.weight[k] += weight;
          return;
        }
      point.vertex[used] = vertex;
      point.weight[used++] = weight;
    };
    for (std::int64_t k = 0; k < 4; ++k) {
      const float weight = weights[static_cast<std::size_t>(k)];
      if (weight == 0) continue;
      std::int64_t v = first + k;
      if (kind.wrap == Wrap::Periodic) v = (v + n) % n;
      // A pinned end goes on as it came: 2 P0 - P1.
      if (v < 0 || v >= n) {
        const std::uint32_t end = v < 0 ? 0 : n - 1;
        weigh(end, 2 * weight);
        weigh(v < 0 ? 1 : n - 2, -weight);
      } else {
        weigh(static_cast<std::uint32_t>(v), weight);
      }
    }
    points.push_back(point);
  };
  for (std::uint32_t s = 0; s < segments; ++s)
    for (std::uint32_t i = 0; i < steps; ++i)
      add(s, static_cast<float>(i) / static_cast<float>(steps));
  add(segments - 1, 1);
  return points;
}

}  // namespace hair

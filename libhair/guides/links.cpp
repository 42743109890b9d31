#include <libhair/guides/links.h>

#include <array>

#include <libhair/guides/guide_strands.h>

namespace hair {

void correctLinks(std::uint32_t points, const Lanes* linkLength, const Lanes* inverseMass,
                  const ContactPlane* planes, const LaneMask* touching, Lanes* lambda,
                  LaneVec3* x) {
  // How much of its freedom along the normal a touching point loses. Not all of it: a link that
  // stands on its contact would have no freedom left, and the system no solution.
  constexpr float kSlide = 0.98f;
  const std::uint32_t links = points - 1;
  std::array<LaneVec3, kMaxGuidePoints> d;
  std::array<Lanes, kMaxGuidePoints> lengthNow, above, right;
  for (std::uint32_t i = 0; i < links; ++i) {
    const LaneVec3 e = x[i + 1] - x[i];
    lengthNow[i] = max(length(e), lanes(1e-9f));
    d[i] = (1.0f / lengthNow[i]) * e;
  }
  // (W_i a)·b for directions a and b at point i.
  const auto through = [&](std::uint32_t i, LaneVec3 a, LaneVec3 b) {
    const Lanes slide = touching[i] ? lanes(kSlide) : lanes(0);
    return inverseMass[i] *
           (dot(a, b) - slide * dot(planes[i].normal, a) * dot(planes[i].normal, b));
  };
  // Thomas: forward sweep.
  for (std::uint32_t i = 0; i < links; ++i) {
    Lanes diagonal = through(i, d[i], d[i]) + through(i + 1, d[i], d[i]);
    Lanes rhs = linkLength[i] - lengthNow[i];
    if (i > 0) {
      const Lanes below = -through(i, d[i - 1], d[i]);
      diagonal = diagonal - below * above[i - 1];
      rhs = rhs - below * right[i - 1];
    }
    const Lanes pivot = 1.0f / max(diagonal, 1e-6f * inverseMass[i + 1]);
    above[i] = i + 1 < links ? -through(i + 1, d[i], d[i + 1]) * pivot : Lanes{};
    right[i] = rhs * pivot;
  }
  // Backward.
  for (std::uint32_t i = links; i-- > 0;) {
    if (i + 1 < links) right[i] = right[i] - above[i] * right[i + 1];
    lambda[i] += right[i];
  }
  for (std::uint32_t i = 1; i <= links; ++i) {
    LaneVec3 move = right[i - 1] * d[i - 1];
    if (i < links) move = move - right[i] * d[i];
    const Lanes into = touching[i] ? lanes(kSlide) * dot(planes[i].normal, move) : lanes(0);
    x[i] = x[i] + inverseMass[i] * (move - into * planes[i].normal);
  }
}

void finishLinks(std::uint32_t points, const Lanes* linkLength, const ContactPlane* planes,
                 LaneVec3* x) {
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Lanes l = linkLength[i];
    const LaneVec3 e = x[i + 1] - x[i];
    LaneVec3 direction = (1.0f / max(length(e), lanes(1e-9f))) * e;
    LaneVec3 end = x[i] + l * direction;
    const ContactPlane& plane = planes[i + 1];
    const LaneMask inside = dot(plane.normal, end) < plane.offset;
    if (any(inside)) {
      // On the circle that the sphere of radius l about x_i cuts out of the plane, the point
      // nearest to where the link points: climb by `rise` along the normal, keep the heading.
      const Lanes rise = min(max(plane.offset - dot(plane.normal, x[i]), -l), l);
      const LaneVec3 flat = direction - dot(direction, plane.normal) * plane.normal;
      const Lanes run = sqrt(max(l * l - rise * rise, lanes(0))) / max(length(flat), lanes(1e-9f));
      end = select(inside, x[i] + rise * plane.normal + run * flat, end);
    }
    x[i + 1] = end;
  }
}

}  // namespace hair

#include <libhair/guides/bending.h>

#include <array>

namespace hair {

namespace {

// One lane, in double precision: the factors lose digits where links are short and h is long.
void factorLane(const GuideStrands& guides, std::size_t group, std::size_t lane, double h,
                BendingFactors& out) {
  const std::size_t n = guides.pointsPerGuide(), links = n - 1;
  std::array<double, kMaxGuidePoints> diagonal{}, below1{}, below2{}, d{}, l1{}, l2{};
  for (std::size_t i = 0; i < n; ++i) diagonal[i] = guides.pointMass[group * n + i][lane] / (h * h);
  for (std::size_t i = 0; i < links; ++i) {
    // q_i = d_i - d_(i-1) in terms of points i - 1, i and i + 1.
    const double kappa = guides.jointStiffness[group * links + i][lane];
    const double next = 1.0 / guides.linkLength[group * links + i][lane];
    const double before = i > 0 ? 1.0 / guides.linkLength[group * links + i - 1][lane] : 0.0;
    diagonal[i + 1] += kappa * next * next;
    diagonal[i] += kappa * (next + before) * (next + before);
    below1[i + 1] -= kappa * next * (next + before);
    if (i == 0) continue;
    diagonal[i - 1] += kappa * before * before;
    below1[i] -= kappa * before * (next + before);
    below2[i + 1] += kappa * next * before;
  }
  for (std::size_t i = 1; i < n; ++i) {
    l2[i] = i > 2 ? below2[i] / d[i - 2] : 0;
    l1[i] = i > 1 ? (below1[i] - (i > 2 ? l2[i] * d[i - 2] * l1[i - 1] : 0)) / d[i - 1] : 0;
    d[i] = diagonal[i] - (i > 1 ? l1[i] * l1[i] * d[i - 1] : 0) -
           (i > 2 ? l2[i] * l2[i] * d[i - 2] : 0);
    out.inverseD[group * n + i][lane] = static_cast<float>(1.0 / d[i]);
    out.below1[group * n + i][lane] = static_cast<float>(l1[i]);
    out.below2[group * n + i][lane] = static_cast<float>(l2[i]);
  }
}

}  // namespace

void factorBending(const GuideStrands& guides, float substep, BendingFactors& factors) {
  const std::size_t size = guides.groupCount() * guides.pointsPerGuide();
  if (factors.substep == substep && factors.inverseD.size() == size) return;
  factors.substep = substep;
  for (auto* f : {&factors.inverseD, &factors.below1, &factors.below2}) f->assign(size, Lanes{});
  for (std::size_t g = 0; g < guides.groupCount(); ++g)
    for (std::size_t l = 0; l < kLanes; ++l) factorLane(guides, g, l, substep, factors);
}

void solveBending(std::uint32_t points, const LaneVec3* curvature, const Lanes* jointStiffness,
                  const Lanes* linkLength, const Lanes* inverseD, const Lanes* below1,
                  const Lanes* below2, LaneVec3 tangent, LaneVec3 normal, LaneVec3* force,
                  LaneVec3* x) {
  LaneVec3* r = force;
  // r = f - grad E(x). Frames are carried along the chain while we go; `before` is the
  // direction of the link before, over its rest length, as E is quadratic in the points.
  LaneVec3 before = tangent;
  const std::uint32_t links = points - 1;
  for (std::uint32_t i = 0; i < links; ++i) {
    const Lanes inverseLength = 1.0f / linkLength[i];
    const LaneVec3 d = inverseLength * (x[i + 1] - x[i]);
    const LaneVec3 binormal = cross(tangent, normal);
    const LaneVec3 c =
        curvature[i].x * normal + curvature[i].y * binormal + curvature[i].z * tangent;
    const LaneVec3 g = jointStiffness[i] * (d - before - c);
    // g_i pushes on link i, and back on link i - 1.
    const LaneVec3 onThis = inverseLength * g;
    r[i + 1] = r[i + 1] - onThis;
    r[i] = r[i] + onThis;
    if (i > 0) {
      const LaneVec3 onBefore = (1.0f / linkLength[i - 1]) * g;
      r[i] = r[i] + onBefore;
      r[i - 1] = r[i - 1] - onBefore;
    }
    const LaneVec3 direction = (1.0f / max(length(d), lanes(1e-12f))) * d;
    normal = transportNormal(normal, tangent, direction);
    tangent = direction;
    before = d;
  }
  // Forward sweep, then backward: delta overwrites r.
  for (std::uint32_t i = 2; i <= links; ++i) {
    r[i] = r[i] - below1[i] * r[i - 1];
    if (i > 2) r[i] = r[i] - below2[i] * r[i - 2];
  }
  for (std::uint32_t i = 1; i <= links; ++i) r[i] = inverseD[i] * r[i];
  for (std::uint32_t i = links; i >= 1; --i) {
    if (i + 1 <= links) r[i] = r[i] - below1[i + 1] * r[i + 1];
    if (i + 2 <= links) r[i] = r[i] - below2[i + 2] * r[i + 2];
    x[i] = x[i] + r[i];
  }
}

}  // namespace hair

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
    const double kappa = (1.0 + out.damping) * guides.jointStiffness[group * links + i][lane];
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

void factorBending(const GuideStrands& guides, float substep, float bendDamping,
                   BendingFactors& factors) {
  const float damping = bendDamping / substep;
  const std::size_t size = guides.groupCount() * guides.pointsPerGuide();
  if (factors.substep == substep && factors.damping == damping && factors.inverseD.size() == size)
    return;
  factors.substep = substep;
  factors.damping = damping;
  for (auto* f : {&factors.inverseD, &factors.below1, &factors.below2}) f->assign(size, Lanes{});
  for (std::size_t g = 0; g < guides.groupCount(); ++g)
    for (std::size_t l = 0; l < kLanes; ++l) factorLane(guides, g, l, substep, factors);
}

namespace {

// Walks a chain from the root and gives the strain of each joint in the frame carried there.
class StrainWalk {
 public:
  explicit StrainWalk(const RootFrame& root)
      : direction_(root.tangent), tangent_(root.tangent), normal_(root.normal) {}

  // Strain of the joint before the link with these ends; `direction` is over the rest length, as E
  // is quadratic in the points.
  LaneVec3 strain(LaneVec3 direction, LaneVec3 curvature) const {
    const LaneVec3 bent = direction - direction_;
    return LaneVec3{dot(bent, normal_), dot(bent, cross(tangent_, normal_)), dot(bent, tangent_)} -
           curvature;
  }
  LaneVec3 toWorld(LaneVec3 v) const {
    return v.x * normal_ + v.y * cross(tangent_, normal_) + v.z * tangent_;
  }
  void over(LaneVec3 direction) {
    const LaneVec3 unit = (1.0f / max(length(direction), lanes(1e-12f))) * direction;
    normal_ = transportNormal(normal_, tangent_, unit);
    tangent_ = unit;
    direction_ = direction;
  }

 private:
  LaneVec3 direction_, tangent_, normal_;
};

}  // namespace

void solveBending(const BendingGroup& group, const RootFrame& root, const RootFrame& rootBefore,
                  const LaneVec3* before, LaneVec3* force, LaneVec3* x) {
  LaneVec3* r = force;
  const std::uint32_t links = group.points - 1;
  // r = f - grad E(x) - damping.
  StrainWalk now(root), then(rootBefore);
  for (std::uint32_t i = 0; i < links; ++i) {
    const Lanes inverseLength = 1.0f / group.linkLength[i];
    const LaneVec3 d = inverseLength * (x[i + 1] - x[i]);
    const LaneVec3 dThen = inverseLength * (before[i + 1] - before[i]);
    // The rate of the strain is taken in the carried frame, where turning with the head is none.
    const LaneVec3 e = now.strain(d, group.curvature[i]);
    const LaneVec3 change = e - then.strain(dThen, group.curvature[i]);
    const LaneVec3 g = group.jointStiffness[i] * now.toWorld(e + lanes(group.damping) * change);
    // g_i pushes on link i, and back on link i - 1.
    const LaneVec3 onThis = inverseLength * g;
    r[i + 1] = r[i + 1] - onThis;
    r[i] = r[i] + onThis;
    if (i > 0) {
      const LaneVec3 onBefore = (1.0f / group.linkLength[i - 1]) * g;
      r[i] = r[i] + onBefore;
      r[i - 1] = r[i - 1] - onBefore;
    }
    now.over(d);
    then.over(dThen);
  }
  // Forward sweep, then backward: the movement overwrites r.
  for (std::uint32_t i = 2; i <= links; ++i) {
    r[i] = r[i] - group.below1[i] * r[i - 1];
    if (i > 2) r[i] = r[i] - group.below2[i] * r[i - 2];
  }
  for (std::uint32_t i = 1; i <= links; ++i) r[i] = group.inverseD[i] * r[i];
  for (std::uint32_t i = links; i >= 1; --i) {
    if (i + 1 <= links) r[i] = r[i] - group.below1[i + 1] * r[i + 1];
    if (i + 2 <= links) r[i] = r[i] - group.below2[i + 2] * r[i + 2];
    x[i] = x[i] + r[i];
  }
}

}  // namespace hair

#include <libhair/guides/bending.h>

#include <array>

namespace hair {

namespace {

// Sets the largest tension and compression of link i. Returns its rest tension under this weight
// where that is beyond the explicit limit and so must join the system, else 0.
double limitTension(const GuideStrands& guides, std::size_t group, std::size_t lane, std::size_t i,
                    double h, BendingFactors& out) {
  const std::size_t n = guides.pointsPerGuide(), at = group * (n - 1) + i;
  const auto step = static_cast<float>(h);
  const float bears = 0.25f / (step * step) * guides.pointMass[group * n + i + 1][lane] *
                      guides.linkLength[at][lane];
  const float rest = out.weight * guides.restTension[at][lane];
  const float held = rest > bears ? rest : 0.0f;
  out.mostTension[at][lane] = bears + held;
  out.mostCompression[at][lane] = bears;
  return held;
}

// Factors the system of one guide, in double precision: digits cancel where links are short and h
// is long.
void factorLane(const GuideStrands& guides, std::size_t group, std::size_t lane, double h,
                BendingFactors& out) {
  const std::size_t n = guides.pointsPerGuide(), links = n - 1;
  std::array<double, kMaxGuidePoints> diagonal{}, below1{}, below2{}, d{}, l1{}, l2{};
  // Put M / h² on the diagonal. Tied points move with the head under any force: give them a very
  // large mass.
  constexpr double kTied = 1e12;
  for (std::size_t i = 0; i < n; ++i)
    diagonal[i] = guides.pointMass[group * n + i][lane] / (h * h) *
                  (guides.inverseMass[group * n + i][lane] > 0 ? 1 : kTied);
  for (std::size_t i = 0; i < links; ++i) {
    // Add the energy of joint i: d_i - d_(i-1) in terms of points i - 1, i and i + 1.
    const double kappa = (1.0 + out.damping) * guides.jointStiffness[group * links + i][lane];
    const double next = 1.0 / guides.linkLength[group * links + i][lane];
    const double before = i > 0 ? 1.0 / guides.linkLength[group * links + i - 1][lane] : 0.0;
    const double taut = limitTension(guides, group, lane, i, h, out) * next;
    diagonal[i + 1] += kappa * next * next + taut;
    diagonal[i] += kappa * (next + before) * (next + before) + taut;
    below1[i + 1] -= kappa * next * (next + before) + taut;
    if (i == 0) continue;
    diagonal[i - 1] += kappa * before * before;
    below1[i] -= kappa * before * (next + before);
    below2[i + 1] += kappa * next * before;
  }
  // Factor: below1 and below2 become L, diagonal becomes D. Leave out the root, which is fixed.
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

void factorBending(const GuideStrands& guides, float substep, float bendDamping, float weight,
                   BendingFactors& factors) {
  const float damping = bendDamping / substep;
  const std::size_t size = guides.groupCount() * guides.pointsPerGuide();
  if (factors.substep == substep && factors.damping == damping && factors.weight == weight &&
      factors.inverseD.size() == size)
    return;
  factors.substep = substep;
  factors.damping = damping;
  factors.weight = weight;
  for (auto* f : {&factors.inverseD, &factors.below1, &factors.below2}) f->assign(size, Lanes{});
  for (auto* f : {&factors.mostTension, &factors.mostCompression})
    f->assign(guides.restTension.size(), Lanes{});
  for (std::size_t g = 0; g < guides.groupCount(); ++g)
    for (std::size_t l = 0; l < kLanes; ++l) factorLane(guides, g, l, substep, factors);
}

}  // namespace hair

#include <libhair/guides/measure.h>

#include <algorithm>
#include <cmath>

#include <libhair/guides/contact.h>
#include <libhair/model/mesh_sdf.h>

namespace hair {

namespace {

// The larger of the two, but NaN once there is one: hair that has gone wrong must show.
void worse(float& worst, float value) {
  if (!(value <= worst) && !std::isnan(worst)) worst = value;
}

}  // namespace

GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head) {
  GuideStats stats;
  const std::uint32_t n = guides.pointsPerGuide();
  const RigidTransform headFromWorld = inverse(guides.worldFromHead);
  double stretch2 = 0;
  for (std::size_t g = 0; g < guides.guideCount(); ++g) {
    const std::size_t group = g / kLanes, l = g % kLanes;
    float way = 0;
    // How deep a capsule has the place where the head holds this point (contact.h), not above 0.
    const auto swallowed = [&](const Capsule& c, std::uint32_t i, float after) {
      const std::size_t anchor = group * n + std::min(i, kAnchoredPoints);
      const glm::vec3 held = guides.worldFromHead.point(lane(guides.restPosition[anchor], l));
      return std::min(0.0f, distanceAndGradient(c, held).w + kReachGrowth * after);
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::vec3 p = guides.point(g, i);
      const std::size_t at = group * n + i;
      const glm::vec3 v(guides.velocity[at].x[l], guides.velocity[at].y[l],
                        guides.velocity[at].z[l]);
      worse(stats.speedMax, glm::length(v));
      stats.kineticEnergy += 0.5 * settings.linearDensity * guides.pointMass[at][l] *
                             static_cast<double>(glm::dot(v, v));
      if (i == 0) continue;
      if (i > kAnchoredPoints) way += guides.linkLength[group * (n - 1) + i - 1][l];
      for (const Capsule& c : capsules)
        worse(stats.penetrationMax, swallowed(c, i, way) - distanceAndGradient(c, p).w);
      if (head)
        worse(stats.penetrationMax,
              std::min(0.0f, guides.clearance[at][l]) - head->distance(headFromWorld.point(p)));
      const float l0 = guides.linkLength[group * (n - 1) + i - 1][l];
      const float s = std::abs(glm::distance(p, guides.point(g, i - 1)) - l0) / l0;
      worse(stats.stretchMax, s);
      stretch2 += static_cast<double>(s) * s;
    }
  }
  stats.stretchRms =
      static_cast<float>(std::sqrt(stretch2 / static_cast<double>(guides.guideCount() * (n - 1))));
  return stats;
}

}  // namespace hair

#include <libhair/guides/measure.h>

#include <algorithm>
#include <cmath>

#include <libhair/model/mesh_sdf.h>

namespace hair {

GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head) {
  GuideStats stats;
  const std::uint32_t n = guides.pointsPerGuide();
  const RigidTransform headFromWorld = inverse(guides.worldFromHead);
  double stretch2 = 0;
  for (std::size_t g = 0; g < guides.guideCount(); ++g) {
    const std::size_t group = g / kLanes, lane = g % kLanes;
    const glm::vec3 root = guides.point(g, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::vec3 p = guides.point(g, i);
      const std::size_t at = group * n + i;
      const glm::vec3 v(guides.velocity[at].x[lane], guides.velocity[at].y[lane],
                        guides.velocity[at].z[lane]);
      stats.speedMax = std::max(stats.speedMax, glm::length(v));
      stats.kineticEnergy += 0.5 * settings.linearDensity * guides.pointMass[at][lane] *
                             static_cast<double>(glm::dot(v, v));
      if (i == 0) continue;
      for (const Capsule& c : capsules)
        stats.penetrationMax =
            std::max(stats.penetrationMax,
                     std::min(0.0f, distanceAndGradient(c, root).w) - distanceAndGradient(c, p).w);
      if (head)
        stats.penetrationMax =
            std::max(stats.penetrationMax, std::min(0.0f, guides.clearance[at][lane]) -
                                               head->distance(headFromWorld.point(p)));
      const float l0 = guides.linkLength[group * (n - 1) + i - 1][lane];
      const float s = std::abs(glm::distance(p, guides.point(g, i - 1)) - l0) / l0;
      stats.stretchMax = std::max(stats.stretchMax, s);
      stretch2 += static_cast<double>(s) * s;
    }
  }
  stats.stretchRms =
      static_cast<float>(std::sqrt(stretch2 / static_cast<double>(guides.guideCount() * (n - 1))));
  return stats;
}

}  // namespace hair

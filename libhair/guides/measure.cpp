#include <libhair/guides/guide_strands.h>

#include <algorithm>
#include <cmath>

#include <libhair/geometry/mesh_sdf.h>
#include <libhair/guides/contact.h>

namespace hair {

namespace {

// Keeps the larger of the two. NaN is kept for good: broken hair must show in the figures.
void worse(float& worst, float value) {
  if (!(value <= worst) && !std::isnan(worst)) worst = value;
}

}  // namespace

GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head,
                         const Scenery& scenery) {
  GuideStats stats;
  const std::uint32_t n = guides.pointsPerGuide();
  const RigidTransform headFromWorld = inverse(guides.worldFromHead);
  double stretch2 = 0;
  for (std::size_t g = 0; g < guides.guideCount(); ++g) {
    const std::size_t group = g / kLanes, l = g % kLanes;
    float way = 0;
    // Depth of point i in a collider beyond the depth that its rest position allows (contact.h).
    const auto deeper = [&](const auto& collider, std::uint32_t i) {
      const std::size_t anchor = group * n + std::min(i, kAnchoredPoints);
      const glm::vec3 held = guides.worldFromHead.point(lane(guides.restPosition[anchor], l));
      const float covered = distanceAndGradient(collider, held).w + kReachGrowth * way;
      return std::min(0.0f, covered) - distanceAndGradient(collider, guides.point(g, i)).w;
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
      for (const Capsule& c : capsules) worse(stats.penetrationMax, deeper(c, i));
      for (const Plane& plane : scenery.planes) worse(stats.penetrationMax, deeper(plane, i));
      for (const MeshCollider& mesh : scenery.meshes) worse(stats.penetrationMax, deeper(mesh, i));
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

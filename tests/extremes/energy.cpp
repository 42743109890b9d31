#include "energy.h"

#include <cmath>

namespace hair::extremes {

namespace {

/// Bending energy of one guide, per linear density (GuideStrands).
double bendingOf(const GuideStrands& guides, std::size_t guide) {
  const std::size_t links = guides.linksPerGuide(), group = guide / kLanes, l = guide % kLanes;
  const RigidTransform& head = guides.worldFromHead;
  glm::vec3 tangent = head.vector(lane(guides.rootTangent[group], l));
  glm::vec3 normal = head.vector(lane(guides.rootNormal[group], l));
  double energy = 0;
  for (std::uint32_t i = 0; i < links; ++i) {
    const std::size_t at = group * links + i;
    const glm::vec3 d = glm::normalize(guides.point(guide, i + 1) - guides.point(guide, i));
    const glm::vec3 c = lane(guides.curvature[at], l), bend = d - tangent;
    const glm::dvec3 strain =
        glm::dvec3(glm::dot(bend, normal), glm::dot(bend, glm::cross(tangent, normal)),
                   glm::dot(bend, tangent)) -
        glm::dvec3(c);
    energy += 0.5 * guides.jointStiffness[at][l] * glm::dot(strain, strain);
    normal = transport(normal, tangent, d);
    tangent = d;
  }
  return energy;
}

}  // namespace

double energyOf(const GuideStrands& guides, const RigidTransform& before, double seconds,
                glm::vec3 gravity) {
  const std::uint32_t n = guides.pointsPerGuide();
  const RigidTransform back = before * inverse(guides.worldFromHead);
  const glm::dvec3 at(guides.worldFromHead.translation);
  const glm::dvec3 drift = (at - glm::dvec3(before.translation)) / seconds;
  const glm::dquat turn(glm::conjugate(back.rotation));
  const glm::dvec3 spin =
      glm::angle(turn) > 1e-6 ? glm::axis(turn) * (glm::angle(turn) / seconds) : glm::dvec3(0);
  double most = -INFINITY;
  for (std::size_t g = 0; g < guides.guideCount(); ++g) {
    const std::size_t group = g / kLanes, l = g % kLanes;
    const glm::dvec3 root(guides.point(g, 0));
    double mass = guides.pointMass[group * n][l], energy = bendingOf(guides, g);
    for (std::uint32_t i = 1; i < n; ++i) {
      const std::size_t k = group * n + i;
      const glm::dvec3 p(guides.point(g, i)), v(lane(guides.velocity[k], l));
      const glm::dvec3 u = v - drift - glm::cross(spin, p - at);
      const double m = guides.pointMass[k][l];
      mass += m;
      energy += m * (0.5 * glm::dot(u, u) - glm::dot(glm::dvec3(gravity), p - root));
    }
    // Once there is no number, it stays.
    if (!(energy / mass <= most)) most = energy / mass;
  }
  return most;
}

}  // namespace hair::extremes

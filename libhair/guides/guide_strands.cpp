#include <libhair/guides/guide_strands.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/guides/rest_shape.h>
#include <libhair/guides/validate.h>

namespace hair {

glm::vec3 rootNormalOf(glm::vec3 rootDirection) {
  return anyNormal(rootDirection);
}

void validate(const GuideSettings& s) {
  validateFields(s, "guide settings");
}

GuideStrands::GuideStrands(const Groom& groom, const GuideSettings& settings,
                           const RigidTransform& worldFromHead_, const MeshSdf* head)
    : guideCount_(groom.guideCount()),
      points_(groom.pointsPerGuide),
      restGravity_(glm::length(settings.gravity)) {
  validate(settings);
  validateGuides(groom);
  const std::size_t groups = groupCount(), n = points_, links = n - 1;
  position.resize(groups * n);
  velocity.resize(groups * n);
  restPosition.resize(groups * n);
  clearance.resize(groups * n);
  pointMass.resize(groups * n);
  inverseMass.resize(groups * n);
  rootTangent.resize(groups);
  rootNormal.resize(groups);
  tension.resize(groups * links);
  restTension.resize(groups * links);
  linkLength.resize(groups * links);
  inverseLength.resize(groups * links);
  curvature.resize(groups * links);
  jointStiffness.resize(groups * links);
  hasUnevenLinks.resize(groups);
  tied.assign(groups, 1);
  // Fill all lanes; those beyond the last guide repeat it.
  for (std::size_t slot = 0; slot < groups * kLanes; ++slot) {
    const std::size_t guide = std::min(slot, guideCount_ - 1), group = slot / kLanes,
                      l = slot % kLanes;
    const auto points = groom.guide(guide);
    // Make the rest shape, in a frame at the root.
    const glm::vec3 first = points[1] - points[0];
    const glm::vec3 direction = glm::length(first) > 0 ? glm::normalize(first) : glm::vec3(0, 1, 0);
    const RestShape rest = makeRestShape(points, rootNormalOf(direction), settings, guide);
    setLane(rootTangent[group], l, direction);
    setLane(rootNormal[group], l, rootNormalOf(direction));
    // Set the points. The root is always tied.
    const std::uint32_t held = groom.tied.empty() ? 1 : std::clamp(groom.tied[guide], 1u, points_);
    tied[group] = std::max(tied[group], held);
    for (std::size_t i = 0; i < n; ++i) {
      setLane(restPosition[group * n + i], l, points[i]);
      clearance[group * n + i][l] =
          head ? std::min(settings.skin, head->distance(points[i])) : settings.skin;
      pointMass[group * n + i][l] = rest.mass[i];
      inverseMass[group * n + i][l] = i >= held ? 1.0f / rest.mass[i] : 0.0f;
    }
    // Set the links, and find the one that limits the substep.
    float length = 0;
    for (std::size_t i = 0; i < links; ++i) {
      if (rest.torqueLimit[i] < leastBorne_)
        leastBorne_ = rest.torqueLimit[i], weakestGuide_ = guide, weakestLink_ = i;
      length += rest.linkLength[i];
      shortestLink_ = std::min(shortestLink_, rest.linkLength[i]);
      linkLength[group * links + i][l] = rest.linkLength[i];
      inverseLength[group * links + i][l] = 1.0f / rest.linkLength[i];
      restTension[group * links + i][l] = rest.tension[i];
      setLane(curvature[group * links + i], l, rest.curvature[i]);
      jointStiffness[group * links + i][l] = rest.stiffness[i];
    }
    reach_ = std::max(reach_, glm::length(points[0]) + length);
    longestSubstep_ = std::min(longestSubstep_, rest.longestSubstep);
    longestUnderTension_ = std::min(longestUnderTension_, rest.longestUnderTension);
    const auto [least, most] =
        std::minmax_element(rest.linkLength.begin(), rest.linkLength.begin() + links);
    if (*most > kEven * *least) hasUnevenLinks[group] = 1;
  }
  reset(worldFromHead_);
}

float GuideStrands::longestSubstep(const RigidTransform& at, float weight) const {
  const glm::vec3 near = glm::abs(at.translation - stepOrigin(at));
  const float spacing = floatSpacing(std::max({near.x, near.y, near.z}) + reach_);
  const float h = std::sqrt(4 * leastBorne_ / spacing);
  require(h >= kShortestSubstep, "groom: guide ", weakestGuide_, " link ", weakestLink_,
          " is too short for what it carries: it would take substeps of ", h, " s, below ",
          kShortestSubstep, "; take longer or more even links");
  // Take at least the time in which gravity moves a point by 25 spacings.
  const float floor = std::max(1.0f / 6000, std::sqrt(25 * spacing / 9.81f));
  const float taut =
      std::max(std::max(longestUnderTension_, floor) / std::sqrt(weight), kShortestSubstep);
  return std::min({h, longestSubstep_, taut});
}

void GuideStrands::reset(const RigidTransform& to) {
  validate(to);
  requirePrecision(*this, to);
  longestSubstep(to);
  worldFromHead = to;
  for (std::size_t k = 0; k < position.size(); ++k) {
    for (std::size_t l = 0; l < kLanes; ++l)
      setLane(position[k], l, to.point(lane(restPosition[k], l)));
    velocity[k] = LaneVec3{};
  }
  tension = restTension;
}

glm::vec3 GuideStrands::point(std::size_t guide, std::uint32_t i) const {
  return lane(position[guide / kLanes * points_ + i], guide % kLanes);
}

void GuideStrands::copyPoints(std::span<glm::vec3> out) const {
  require(out.size() == guideCount_ * points_, "copyPoints: output has ", out.size(),
          " points, needs ", guideCount_ * points_);
  for (std::size_t g = 0; g < guideCount_; ++g)
    for (std::uint32_t i = 0; i < points_; ++i) out[g * points_ + i] = point(g, i);
}

void GuideStrands::addTo(StateHash& hash) const {
  hash.add(std::span<const LaneVec3>(position));
  hash.add(std::span<const LaneVec3>(velocity));
}

}  // namespace hair

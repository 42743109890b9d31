#include <libhair/motion/head_motion.h>

namespace hair {

RigidTransform worldFromHead(const Body& body, std::span<const RigidTransform> worldFromJoint) {
  return worldFromJoint[static_cast<std::size_t>(body.map.head)] * body.jointFromHead;
}

glm::vec3 bodyFacing(const BodyMap& map, std::span<const RigidTransform> worldFromJoint) {
  const auto at = [&](int j) { return worldFromJoint[static_cast<std::size_t>(j)].translation; };
  // Shoulders and hips each vote: the trunk twists, and arms pull shoulders about.
  const glm::vec3 up = glm::normalize(at(map.neck) - at(map.hips));
  const glm::vec3 shoulders = at(map.upperArm[0]) - at(map.upperArm[1]);
  const glm::vec3 hips = at(map.thigh[0]) - at(map.thigh[1]);
  const glm::vec3 left = 2.0f * glm::normalize(shoulders) + glm::normalize(hips);
  return glm::normalize(glm::cross(left, up));
}

}  // namespace hair

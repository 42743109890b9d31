#pragma once

#include <array>

#include <glm/glm.hpp>

#include <libhair/motion/body.h>

namespace hair {

/// Places on a body from which its flesh is measured. Body space, rest stance; sides: 0 left.
struct Landmarks {
  float size;                    ///< Body::size: a length of a person of 1.68 m, times this
  glm::vec3 pelvis, neck, head;  ///< between the hip joints; root of the neck; joint of the head
  std::array<glm::vec3, 2> shoulder, elbow, wrist, knuckles, fingertips;
  std::array<glm::vec3, 2> handFlat;  ///< unit, across the palm
  std::array<glm::vec3, 2> hip, knee, ankle, heel, ball, toe;

  std::array<int, 2> toes;  ///< the joint that bends the toes; the foot itself where none

  /// Middle of the trunk at a height between pelvis (0) and root of the neck (1).
  glm::vec3 trunk(float t) const;
  /// Half the distance of the shoulder joints.
  float halfShoulders() const { return 0.5f * glm::distance(shoulder[0], shoulder[1]); }
};

/// The body must be complete (BodyMap::complete).
Landmarks landmarksOf(const Body& body);

/// The joint of hips and spine whose bone is at a place of the trunk (body space, rest stance).
int trunkJointAt(const Body& body, glm::vec3 place);

}  // namespace hair

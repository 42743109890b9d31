#include <libhair/motion/body.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/motion/body_colliders.h>
#include <libhair/motion/person_frame.h>
#include <libhair/motion/rest_stance.h>

namespace hair {
namespace {

constexpr glm::vec3 kUp(0, 1, 0), kFront(0, 0, 1);

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// Mean over about 200 frames of the clip of +Y, in the joint's frame; to the axis of the frame
/// that is within 25 degrees.
glm::vec3 meanUpIn(const Clip& clip, int joint) {
  std::vector<RigidTransform> pose(clip.skeleton.jointCount());
  glm::vec3 sum(0);
  const std::size_t step = clip.frameCount() / 200 + 1;
  for (std::size_t f = 0; f < clip.frameCount(); f += step) {
    poseAtFrame(clip, f, pose);
    sum += glm::conjugate(pose[index(joint)].rotation) * kUp;
  }
  if (!(glm::length(sum) > 1e-6f)) return kUp;
  sum = glm::normalize(sum);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(sum[axis]) < 0.906f) continue;
    glm::vec3 unit(0);
    unit[axis] = sum[axis] < 0 ? -1.0f : 1.0f;
    return unit;
  }
  return sum;
}

/// Puts the origin of body space between the feet, on the floor under them.
void centre(Body& body) {
  const auto at = [&](int j) { return body.rest[index(j)].translation; };
  glm::vec3 origin = 0.5f * (at(body.map.foot[0]) + at(body.map.foot[1]));
  float floor = origin.y;
  for (std::size_t j = 0; j < body.rest.size(); ++j)
    floor =
        std::min({floor, body.rest[j].translation.y, body.rest[j].point(body.skeleton.tips[j]).y});
  origin.y = floor;
  for (RigidTransform& joint : body.rest) joint.translation -= origin;
}

}  // namespace

Body makeBody(const Clip& clip, std::string_view headJoint) {
  require(clip.frameCount() > 0, "body: the clip has no frames");
  Body body;
  body.skeleton = clip.skeleton;
  body.map = mapBody(clip, headJoint);
  require(body.map.head >= 0, "body: which of the skeleton's ", body.skeleton.jointCount(),
          " joints is the head? Neither a name nor what hangs on what tells; --head-joint takes "
          "one of ",
          jointList(body.skeleton));
  const std::size_t head = index(body.map.head);
  if (!body.map.complete()) {
    body.rest = zeroPose(body.skeleton);
    body.notes.emplace_back(
        "body: neither names nor bones tell hips, neck, arms or legs; head taken upright as in the "
        "mean of the clip, one capsule a bone");
    const glm::vec3 up = meanUpIn(clip, body.map.head);
    const glm::vec3 front = std::abs(up.z) > 0.9f ? -up.z * kUp : kFront;
    body.jointFromHead.rotation = rotationFromUpFront(up, front);
    fitCapsules(body);
    return body;
  }
  if (!findRestStance(clip, body))
    body.notes.emplace_back("body: the zero pose does not stand; joint axes told from the bones");
  centre(body);
  body.size = sizeOf(body.skeleton, body.map);
  body.jointFromHead.rotation = glm::conjugate(body.rest[head].rotation);
  fitCapsules(body);
  return body;
}

}  // namespace hair

#include <libhair/motion/body.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/motion/body_colliders.h>
#include <libhair/motion/head_motion.h>

namespace hair {
namespace {

constexpr glm::vec3 kUp(0, 1, 0), kFront(0, 0, 1);
constexpr float kDancerLength = 1.41f;  ///< bodyLength of a person of 1.68 m

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// The pose with all joint rotations zero.
std::vector<RigidTransform> zeroPose(const Skeleton& skeleton) {
  std::vector<RigidTransform> pose(skeleton.jointCount());
  for (std::size_t j = 0; j < pose.size(); ++j) {
    pose[j].translation = skeleton.offsets[j];
    if (skeleton.parents[j] >= 0) pose[j] = pose[index(skeleton.parents[j])] * pose[j];
  }
  return pose;
}

/// Head over hips over feet, shoulders level.
bool isStanding(const BodyMap& map, std::span<const RigidTransform> pose) {
  const auto at = [&](int j) { return pose[index(j)].translation; };
  const auto up = [&](glm::vec3 d) { return d.y > 0.9f * glm::length(d); };
  const auto level = [&](glm::vec3 d) { return std::abs(d.y) < 0.2f * glm::length(d); };
  return up(at(map.head) - at(map.hips)) && up(at(map.thigh[0]) - at(map.foot[0])) &&
         up(at(map.thigh[1]) - at(map.foot[1])) && level(at(map.upperArm[0]) - at(map.upperArm[1]));
}

/// Mean over about 200 frames of the clip of a world direction, in the joint's frame.
glm::vec3 meanInJoint(const Clip& clip, int joint,
                      const std::function<glm::vec3(std::span<const RigidTransform>)>& direction) {
  std::vector<RigidTransform> pose(clip.skeleton.jointCount());
  glm::vec3 sum(0);
  const std::size_t step = clip.frameCount() / 200 + 1;
  for (std::size_t f = 0; f < clip.frameCount(); f += step) {
    poseAtFrame(clip, f, pose);
    sum += glm::conjugate(pose[index(joint)].rotation) * direction(pose);
  }
  return sum;
}

/// Rigs align head and spine joints with the body: snap a mean within 25° of an axis to that axis,
/// so that one dancer's posture is not mistaken for the rig.
glm::vec3 snapped(glm::vec3 direction) {
  direction = glm::normalize(direction);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 0.906f) continue;
    glm::vec3 unit(0);
    unit[axis] = direction[axis] < 0 ? -1.0f : 1.0f;
    return unit;
  }
  return direction;
}

glm::vec3 leftOf(const BodyMap& map, std::span<const RigidTransform> pose) {
  return pose[index(map.thigh[0])].translation - pose[index(map.thigh[1])].translation;
}

/// Estimates bodyFromJoint rotations of the rest stance if the zero pose is not standing.
class StanceFromClip {
 public:
  StanceFromClip(const Clip& clip, Body& body) : clip_(clip), body_(body), map_(body.map) {}

  void find() {
    const Skeleton& skeleton = body_.skeleton;
    turn_.assign(skeleton.jointCount(), glm::quat(1, 0, 0, 0));
    known_.assign(skeleton.jointCount(), false);
    const auto facing = [this](std::span<const RigidTransform> pose) {
      return bodyFacing(map_, pose);
    };
    // Trunk: up along the bone, front as the trunk faces.
    trunk(map_.hips, map_.spine.empty() ? map_.neck : map_.spine.front(), facing);
    for (std::size_t i = 0; i + 1 < map_.spine.size(); ++i)
      trunk(map_.spine[i], map_.spine[i + 1], facing);
    if (!map_.spine.empty()) trunk(map_.chest, map_.neck, facing);
    for (int j = map_.head; j >= 0 && j != map_.chest; j = skeleton.parents[index(j)])
      trunk(j, j == map_.head ? -1 : childTowards(j, map_.head), facing);

    for (std::size_t s = 0; s < 2; ++s) {
      const glm::vec3 out(s == 0 ? 1.0f : -1.0f, 0, 0);
      if (map_.collar[s] >= 0)
        limb(map_.collar[s], offset(map_.upperArm[s]), out, kFront,
             meanInJoint(clip_, map_.collar[s], facing));
      // An elbow bends forearm to the front about the vertical, a knee about the lateral axis.
      const glm::vec3 elbow =
          bend(map_.upperArm[s], map_.upperArm[s], map_.foreArm[s], map_.hand[s]);
      const glm::vec3 elbow2 =
          bend(map_.foreArm[s], map_.upperArm[s], map_.foreArm[s], map_.hand[s]);
      limb(map_.upperArm[s], offset(map_.foreArm[s]), out, -out.x * kUp, elbow);
      limb(map_.foreArm[s], offset(map_.hand[s]), out, -out.x * kUp, elbow2);
      if (const glm::vec3 fingers = bonesOf(map_.hand[s]); glm::length(fingers) > 0)
        limb(map_.hand[s], fingers, out, -out.x * kUp,
             bend(map_.hand[s], map_.upperArm[s], map_.foreArm[s], map_.hand[s]));
      const glm::vec3 left(1, 0, 0);
      const glm::vec3 knee = bend(map_.thigh[s], map_.thigh[s], map_.shin[s], map_.foot[s]);
      const glm::vec3 knee2 = bend(map_.shin[s], map_.thigh[s], map_.shin[s], map_.foot[s]);
      limb(map_.thigh[s], offset(map_.shin[s]), -kUp, left, knee);
      limb(map_.shin[s], offset(map_.foot[s]), -kUp, left, knee2);
      // A foot and its toes stand on the floor most of the time.
      int toes = -1;
      for (std::size_t j = skeleton.jointCount(); j-- > 0;)
        if (skeleton.parents[j] == map_.foot[s]) toes = static_cast<int>(j);
      for (int joint : {map_.foot[s], toes}) {
        if (joint < 0) continue;
        const glm::vec3 up = meanInJoint(clip_, joint, [](auto) { return kUp; });
        const glm::vec3 bone = bonesOf(joint);
        set(joint, up, glm::length(bone) > 0 ? bone : meanInJoint(clip_, joint, facing));
      }
    }
    chain();
  }

 private:
  glm::vec3 offset(int joint) const { return body_.skeleton.offsets[index(joint)]; }

  int childTowards(int joint, int descendant) const {
    while (body_.skeleton.parents[index(descendant)] != joint)
      descendant = body_.skeleton.parents[index(descendant)];
    return descendant;
  }

  /// Along the bones that leave a joint, to tip and children: their mean, zero where none.
  glm::vec3 bonesOf(int joint) const {
    const Skeleton& skeleton = body_.skeleton;
    glm::vec3 sum = skeleton.tips[index(joint)];
    for (std::size_t j = 0; j < skeleton.jointCount(); ++j)
      if (skeleton.parents[j] == joint) sum += skeleton.offsets[j];
    return sum;
  }

  /// Joint axes `up`, `front` (in the joint) are +Y, +Z of body space in the rest stance.
  void set(int joint, glm::vec3 up, glm::vec3 front) {
    turn_[index(joint)] = glm::conjugate(rotationFromUpFront(up, front));
    known_[index(joint)] = true;
  }

  template <class Facing>
  void trunk(int joint, int next, const Facing& facing) {
    glm::vec3 up = next >= 0 ? offset(next) : bonesOf(joint);
    if (next < 0) {
      // A head's children may be eyes or a jaw: trust the bone only if it mostly points up.
      const glm::vec3 mean = glm::normalize(meanInJoint(clip_, joint, [](auto) { return kUp; }));
      if (glm::length(up) == 0 || glm::dot(glm::normalize(up), mean) < 0.8f) up = mean;
    }
    set(joint, snapped(up), snapped(meanInJoint(clip_, joint, facing)));
  }

  /// `bone` (in the joint) points along `axis`, and `hinge` (in the joint) as close as possible to
  /// `side`.
  void limb(int joint, glm::vec3 bone, glm::vec3 axis, glm::vec3 side, glm::vec3 hinge) {
    bone = glm::normalize(bone);
    hinge -= glm::dot(hinge, bone) * bone;
    if (glm::length(hinge) < 1e-4f) hinge = anyNormal(bone);
    turn_[index(joint)] = glm::normalize(rotationFromUpFront(axis, side) *
                                         glm::conjugate(rotationFromUpFront(bone, hinge)));
    known_[index(joint)] = true;
  }

  /// Mean hinge axis between upper and lower bone, in the frame of `joint`.
  glm::vec3 bend(int joint, int upper, int lower, int end) const {
    return meanInJoint(clip_, joint, [=](std::span<const RigidTransform> pose) {
      const auto at = [&](int j) { return pose[index(j)].translation; };
      return glm::cross(at(lower) - at(upper), at(end) - at(lower));
    });
  }

  void chain() {
    const Skeleton& skeleton = body_.skeleton;
    body_.rest.resize(skeleton.jointCount());
    for (std::size_t j = 0; j < skeleton.jointCount(); ++j) {
      const int parent = skeleton.parents[j];
      if (!known_[j] && parent >= 0) turn_[j] = turn_[index(parent)];
      body_.rest[j] = {turn_[j], parent < 0 ? skeleton.offsets[j]
                                            : body_.rest[index(parent)].point(skeleton.offsets[j])};
    }
  }

  const Clip& clip_;
  Body& body_;
  const BodyMap& map_;
  std::vector<glm::quat> turn_;
  std::vector<bool> known_;
};

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

/// Ankle to head along the bones: does not depend on the pose.
float bodyLength(const Body& body) {
  const auto length = [&](int j) { return glm::length(body.skeleton.offsets[index(j)]); };
  float sum = 0.5f * (length(body.map.shin[0]) + length(body.map.shin[1]) +
                      length(body.map.foot[0]) + length(body.map.foot[1]));
  for (int j = body.map.head; j >= 0 && j != body.map.hips; j = body.skeleton.parents[index(j)])
    sum += length(j);
  return sum;
}

}  // namespace

Body makeBody(const Clip& clip) {
  require(clip.frameCount() > 0, "body: the clip has no frames");
  Body body;
  body.skeleton = clip.skeleton;
  body.map = mapBody(body.skeleton);
  require(body.map.head >= 0, "body: no joint of the skeleton's ", body.skeleton.jointCount(),
          " is called head; rename one in the file");
  const std::size_t head = index(body.map.head);
  body.rest = zeroPose(body.skeleton);
  if (!body.map.complete()) {
    body.notes.emplace_back(
        "body: hips, neck, arms or legs were not found by name; head taken upright as in the mean "
        "of the clip, one capsule a bone");
    const glm::vec3 up = snapped(meanInJoint(clip, body.map.head, [](auto) { return kUp; }));
    const glm::vec3 front = std::abs(up.z) > 0.9f ? -up.z * kUp : kFront;
    body.jointFromHead.rotation = rotationFromUpFront(up, front);
    fitCapsules(body);
    return body;
  }
  if (isStanding(body.map, body.rest)) {
    const glm::vec3 facing = glm::cross(leftOf(body.map, body.rest), kUp);
    const glm::quat turn = glm::conjugate(rotationFromUpFront(kUp, facing));
    for (RigidTransform& joint : body.rest) joint = RigidTransform{turn, glm::vec3(0)} * joint;
  } else {
    body.notes.emplace_back("body: the zero pose does not stand; joint axes learnt from the clip");
    StanceFromClip(clip, body).find();
  }
  centre(body);
  body.size = bodyLength(body) / kDancerLength;
  body.jointFromHead.rotation = glm::conjugate(body.rest[head].rotation);
  fitCapsules(body);
  return body;
}

}  // namespace hair

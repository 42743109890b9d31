#include <libhair/motion/rest_stance.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <libhair/core/rotations.h>
#include <libhair/motion/joint_names.h>
#include <libhair/motion/rig_structure.h>

namespace hair {
namespace {

constexpr glm::vec3 kUp(0, 1, 0), kFront(0, 0, 1), kLeft(1, 0, 0);

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// Of unit length; zero where v is no direction.
glm::vec3 unit(glm::vec3 v) {
  const float length = glm::length(v);
  return length > 1e-12f && std::isfinite(length) ? v / length : glm::vec3(0);
}

/// What is left of v beside a unit vector.
glm::vec3 beside(glm::vec3 v, glm::vec3 direction) {
  return v - glm::dot(v, direction) * direction;
}

/// Rigs align the frames of joints with bones and body: a direction within some degrees of an axis
/// is that axis, so that one dancer's posture, or a curved spine, is not mistaken for the rig.
glm::vec3 snapped(glm::vec3 direction, float degrees = 25.0f) {
  direction = unit(direction);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < std::cos(glm::radians(degrees))) continue;
    glm::vec3 at(0);
    at[axis] = direction[axis] < 0 ? -1.0f : 1.0f;
    return at;
  }
  return direction;
}

using Pose = std::span<const RigidTransform>;
using Direction = std::function<glm::vec3(Pose)>;

/// Puts the rest stance together, joint by joint.
class StanceOfRig {
 public:
  StanceOfRig(const Clip& clip, Body& body)
      : body_(body), skeleton_(body.skeleton), map_(body.map) {
    turn_.assign(skeleton_.jointCount(), glm::quat(1, 0, 0, 0));
    known_.assign(skeleton_.jointCount(), false);
    // About 200 poses are enough for means.
    const std::size_t step = clip.frameCount() / 200 + 1;
    for (std::size_t f = 0; f < clip.frameCount(); f += step)
      poseAtFrame(clip, f, poses_.emplace_back(skeleton_.jointCount()));
  }

  void find() {
    trunk(map_.hips, map_.spine.empty() ? map_.neck : map_.spine.front());
    for (std::size_t i = 0; i + 1 < map_.spine.size(); ++i) trunk(map_.spine[i], map_.spine[i + 1]);
    if (!map_.spine.empty() && map_.chest != map_.hips) trunk(map_.chest, map_.neck);
    for (int j = skeleton_.parents[index(map_.head)]; j >= 0 && j != map_.chest && j != map_.hips;
         j = skeleton_.parents[index(j)])
      trunk(j, childTowards(j, map_.head));
    head();
    for (std::size_t s = 0; s < 2; ++s) {
      arm(s);
      leg(s);
    }
    chain();
  }

 private:
  glm::vec3 offset(int joint) const { return skeleton_.offsets[index(joint)]; }

  int childTowards(int joint, int descendant) const {
    while (skeleton_.parents[index(descendant)] != joint)
      descendant = skeleton_.parents[index(descendant)];
    return descendant;
  }

  std::vector<int> childrenOf(int joint) const {
    std::vector<int> children;
    for (std::size_t j = 0; j < skeleton_.jointCount(); ++j)
      if (skeleton_.parents[j] == joint) children.push_back(static_cast<int>(j));
    return children;
  }

  /// Along the bones that leave a joint, to tip and children: their sum, zero where there are none
  /// worth the name.
  glm::vec3 bonesOf(int joint) const {
    glm::vec3 sum = skeleton_.tips[index(joint)];
    for (int c : childrenOf(joint)) sum += offset(c);
    return glm::length(sum) > 0.05f * glm::length(offset(joint)) ? sum : glm::vec3(0);
  }

  /// Mean over the clip of a world direction, in the joint's frame.
  glm::vec3 meanIn(int joint, const Direction& direction) const {
    glm::vec3 sum(0);
    for (const std::vector<RigidTransform>& pose : poses_)
      sum += glm::conjugate(pose[index(joint)].rotation) * direction(pose);
    return sum;
  }

  /// From right to left: shoulders and hips each vote, for the trunk twists and arms pull
  /// shoulders.
  glm::vec3 lateral(Pose pose) const {
    const auto at = [&](int j) { return pose[index(j)].translation; };
    return 2.0f * unit(at(map_.upperArm[0]) - at(map_.upperArm[1])) +
           unit(at(map_.thigh[0]) - at(map_.thigh[1]));
  }

  void set(int joint, glm::quat turn) {
    turn_[index(joint)] = turn;
    known_[index(joint)] = true;
  }

  /// Joint axes `up` and, beside it, `left` (in the joint) are +Y and +X of body space.
  void setUpLeft(int joint, glm::vec3 up, glm::vec3 left) {
    left = snapped(beside(left, up), 40.0f);
    set(joint, glm::conjugate(rotationFromUpFront(up, glm::cross(left, up))));
  }

  void trunk(int joint, int next) {
    const Direction spine = [&](Pose pose) {
      return unit(pose[index(map_.neck)].translation - pose[index(map_.hips)].translation);
    };
    glm::vec3 up = unit(offset(next));
    if (up == glm::vec3(0)) up = unit(meanIn(joint, spine));
    setUpLeft(joint, snapped(up), meanIn(joint, [this](Pose p) { return lateral(p); }));
  }

  void head() {
    const int below = skeleton_.parents[index(map_.head)];
    // The neck, seen from the head: how heads are held differs by less than half a right angle.
    const glm::vec3 neck = unit(meanIn(map_.head, [&](Pose pose) {
      return unit(pose[index(map_.head)].translation - pose[index(below)].translation);
    }));
    const std::vector<JointName> names = jointNames(skeleton_.names);
    glm::vec3 top(0);
    std::array<int, 2> eyes{-1, -1};
    const float shortest = 0.2f * glm::length(offset(map_.head));
    const auto consider = [&](glm::vec3 bone) {
      if (glm::length(bone) > shortest &&
          glm::dot(unit(bone), neck) > std::max(0.5f, glm::dot(top, neck)))
        top = unit(bone);
    };
    consider(skeleton_.tips[index(map_.head)]);
    const std::vector<int> children = childrenOf(map_.head);
    for (int c : children) {
      const JointName& name = names[index(c)];
      // Eyes, ears and the like come in pairs.
      const bool paired = std::any_of(children.begin(), children.end(), [&](int other) {
        return other != c && std::abs(glm::length(offset(other)) - glm::length(offset(c))) <
                                 0.02f * glm::length(offset(c));
      });
      if (likeness(name, NamedPart::Eye) > 0 && name.side >= 0)
        eyes[index(name.side)] = c;
      else if (name.side < 0 && !paired)
        consider(offset(c));
    }
    glm::vec3 up = top == glm::vec3(0) ? snapped(neck, 40.0f) : snapped(top, 35.0f);
    if (up == glm::vec3(0)) up = kUp;
    glm::vec3 left = meanIn(map_.head, [this](Pose p) { return lateral(p); });
    if (eyes[0] >= 0 && eyes[1] >= 0 && offset(eyes[0]) != offset(eyes[1]))
      left = offset(eyes[0]) - offset(eyes[1]);
    setUpLeft(map_.head, up, left);
  }

  /// A joint of a limb whose bone (in the joint) points along `axis` in the rest stance. About the
  /// bone it is as its parent, where the frames of both agree on the bone; else `side` of body
  /// space, which the parent carries, tells.
  void limb(int joint, glm::vec3 bone, glm::vec3 axis, glm::vec3 side) {
    const int parent = skeleton_.parents[index(joint)];
    const glm::quat above =
        parent >= 0 && known_[index(parent)] ? turn_[index(parent)] : turn_[index(map_.chest)];
    bone = unit(bone);
    const glm::vec3 sideOfParent = glm::conjugate(above) * side;
    const int carrier = parent >= 0 ? parent : joint;
    const glm::vec3 seen = unit(
        meanIn(joint, [&](Pose pose) { return pose[index(carrier)].rotation * sideOfParent; }));
    const glm::vec3 along = bone == glm::vec3(0) ? glm::conjugate(above) * axis : bone;
    const bool agrees = glm::dot(above * along, axis) > 0.86f;
    if (bone == glm::vec3(0) || (agrees && glm::dot(unit(beside(seen, along)),
                                                    unit(beside(sideOfParent, along))) > 0.25f)) {
      set(joint, above);
      return;
    }
    bone = snapped(bone);
    glm::vec3 hinge = snapped(beside(seen, bone), 40.0f);
    if (glm::length(beside(hinge, bone)) < 0.1f) hinge = anyNormal(bone);
    set(joint, glm::normalize(rotationFromUpFront(axis, side) *
                              glm::conjugate(rotationFromUpFront(bone, beside(hinge, bone)))));
  }

  /// From `from` down to `to`, in the frame of `from`; joints between them only twist.
  glm::vec3 boneTo(int from, int to) const { return offset(childTowards(from, to)); }

  void arm(std::size_t s) {
    const glm::vec3 out(s == 0 ? 1.0f : -1.0f, 0, 0);
    const auto on = [&](int joint, glm::vec3 bone) {
      fillBetween(joint);
      limb(joint, bone, out, kFront);
    };
    if (map_.collar[s] >= 0) on(map_.collar[s], boneTo(map_.collar[s], map_.upperArm[s]));
    on(map_.upperArm[s], boneTo(map_.upperArm[s], map_.foreArm[s]));
    on(map_.foreArm[s], boneTo(map_.foreArm[s], map_.hand[s]));
    on(map_.hand[s], bonesOf(map_.hand[s]));
  }

  void leg(std::size_t s) {
    const auto on = [&](int joint, glm::vec3 bone, glm::vec3 axis) {
      fillBetween(joint);
      limb(joint, bone, axis, kLeft);
    };
    on(map_.thigh[s], boneTo(map_.thigh[s], map_.shin[s]), -kUp);
    on(map_.shin[s], boneTo(map_.shin[s], map_.foot[s]), -kUp);
    foot(s);
  }

  /// Mean of a direction of body space that `parent` carries, in the frame of a joint.
  glm::vec3 meanOf(glm::vec3 ofBody, int parent, int joint) const {
    const glm::vec3 ofParent = glm::conjugate(turn_[index(parent)]) * ofBody;
    return unit(meanIn(joint, [&](Pose pose) { return pose[index(parent)].rotation * ofParent; }));
  }

  /// The turn of a joint whose frame is that of `parent` but for right angles.
  glm::quat squaredTo(int parent, int joint) const {
    const glm::vec3 up = snapped(meanOf(kUp, parent, joint), 45.0f);
    const glm::vec3 left = snapped(beside(meanOf(kLeft, parent, joint), up), 40.0f);
    return glm::conjugate(rotationFromUpFront(up, glm::cross(left, up)));
  }

  void foot(std::size_t s) {
    const int foot = map_.foot[s];
    fillBetween(foot);
    set(foot, turnOfFoot(foot, skeleton_.parents[index(foot)]));
    for (int c : childrenOf(foot)) set(c, squaredTo(foot, c));
  }

  glm::quat turnOfFoot(int foot, int shin) const {
    const glm::quat above = turn_[index(shin)];
    const glm::vec3 bone = unit(bonesOf(foot));
    // To the front, down rather than up.
    const auto leadsOn = [&](glm::quat turn) {
      const glm::vec3 toes = turn * bone;
      return toes.z > 0.5f && std::abs(toes.x) < 0.6f && toes.y < 0.3f;
    };
    const glm::vec3 up = meanOf(kUp, shin, foot);
    if (bone == glm::vec3(0) || (leadsOn(above) && (above * up).y > 0.3f)) return above;
    // Right angles, of those that lead on the nearest; unless an axis is the bone's, which slopes.
    const glm::vec3 left = meanOf(kLeft, shin, foot);
    const glm::vec3 most = glm::abs(bone);
    std::optional<glm::quat> squared;
    float nearest = 0.3f;
    for (int axis = 0; axis < 6; ++axis) {
      glm::vec3 axisUp(0);
      axisUp[axis / 2] = axis % 2 == 0 ? 1.0f : -1.0f;
      const glm::vec3 axisLeft = snapped(beside(left, axisUp), 40.0f);
      const glm::quat turn =
          glm::conjugate(rotationFromUpFront(axisUp, glm::cross(axisLeft, axisUp)));
      if (glm::dot(axisUp, up) < nearest || !leadsOn(turn)) continue;
      nearest = glm::dot(axisUp, up);
      squared = turn;
    }
    if (squared && std::max({most.x, most.y, most.z}) < 0.9995f) return *squared;
    // How far toes point down is seen from the shin, within what an ankle does in standing.
    float cosine = 0;
    for (const std::vector<RigidTransform>& pose : poses_)
      cosine += glm::dot(pose[index(shin)].rotation * unit(offset(foot)),
                         pose[index(foot)].rotation * bone);
    const float dip = std::clamp(cosine / static_cast<float>(poses_.size()), 0.0f, 0.5f);
    const glm::vec3 toes(0, -dip, std::sqrt(1 - dip * dip));
    glm::vec3 hinge = beside(left, bone);
    if (glm::length(hinge) < 1e-4f) hinge = anyNormal(bone);
    return glm::normalize(rotationFromUpFront(toes, kLeft) *
                          glm::conjugate(rotationFromUpFront(bone, hinge)));
  }

  /// Joints that no part of the body is named after are turned as what they hang on.
  void fillBetween(int joint) {
    const int parent = skeleton_.parents[index(joint)];
    if (parent < 0 || known_[index(parent)]) return;
    fillBetween(parent);
    const int above = skeleton_.parents[index(parent)];
    set(parent, above < 0 ? turn_[index(map_.hips)] : turn_[index(above)]);
  }

  void chain() {
    body_.rest.resize(skeleton_.jointCount());
    for (std::size_t j = 0; j < skeleton_.jointCount(); ++j) {
      const int parent = skeleton_.parents[j];
      if (!known_[j] && parent >= 0) turn_[j] = turn_[index(parent)];
      body_.rest[j] = {turn_[j], parent < 0
                                     ? skeleton_.offsets[j]
                                     : body_.rest[index(parent)].point(skeleton_.offsets[j])};
    }
  }

  Body& body_;
  const Skeleton& skeleton_;
  const BodyMap& map_;
  std::vector<std::vector<RigidTransform>> poses_;
  std::vector<glm::quat> turn_;
  std::vector<bool> known_;
};

}  // namespace

std::vector<RigidTransform> zeroPose(const Skeleton& skeleton) {
  std::vector<RigidTransform> pose(skeleton.jointCount());
  for (std::size_t j = 0; j < pose.size(); ++j) {
    pose[j].translation = skeleton.offsets[j];
    if (skeleton.parents[j] >= 0) pose[j] = pose[index(skeleton.parents[j])] * pose[j];
  }
  return pose;
}

bool standsAlong(const BodyMap& map, Pose pose, glm::vec3 up) {
  const auto at = [&](int j) { return pose[index(j)].translation; };
  const auto upwards = [&](glm::vec3 d) { return glm::dot(d, up) > 0.9f * glm::length(d); };
  const auto level = [&](glm::vec3 d) { return std::abs(glm::dot(d, up)) < 0.2f * glm::length(d); };
  return upwards(at(map.head) - at(map.hips)) && upwards(at(map.thigh[0]) - at(map.foot[0])) &&
         upwards(at(map.thigh[1]) - at(map.foot[1])) &&
         level(at(map.upperArm[0]) - at(map.upperArm[1]));
}

bool findRestStance(const Clip& clip, Body& body) {
  const BodyMap& map = body.map;
  body.rest = zeroPose(body.skeleton);
  const auto at = [&](int j) { return body.rest[index(j)].translation; };
  const glm::vec3 up = snapped(at(map.head) - 0.5f * (at(map.foot[0]) + at(map.foot[1])));
  if (!standsAlong(map, body.rest, up)) {
    StanceOfRig(clip, body).find();
    return false;
  }
  const glm::vec3 facing = glm::cross(at(map.thigh[0]) - at(map.thigh[1]), up);
  const glm::quat turn = glm::conjugate(rotationFromUpFront(up, facing));
  for (RigidTransform& joint : body.rest) joint = RigidTransform{turn, glm::vec3(0)} * joint;
  return true;
}

}  // namespace hair

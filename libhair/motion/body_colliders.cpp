#include <libhair/motion/body_colliders.h>

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/motion/landmarks.h>

namespace hair {
namespace {

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// Adds capsules given in body space, rest stance, each end carried by a joint.
class Fitter {
 public:
  explicit Fitter(Body& body) : body_(body) {}

  void add(int jointA, glm::vec3 a, int jointB, glm::vec3 b, float radius, bool yields = false) {
    body_.capsules.push_back({jointA, jointB, inverse(body_.rest[index(jointA)]).point(a),
                              inverse(body_.rest[index(jointB)]).point(b), radius, yields});
  }
  void add(int joint, glm::vec3 a, glm::vec3 b, float radius, bool yields = false) {
    add(joint, a, joint, b, radius, yields);
  }

 private:
  Body& body_;
};

/// Cross-sections of the trunk: half its breadth less its radius, radius (half its depth), height
/// from the hip joints (0) to the root of the neck (1). Metres of a person of 1.68 m; means of
/// women as in NASA-STD-3000, vol. 1, section 3, chest and hip breadth and depth.
struct Slice {
  float height, x, radius;
};
constexpr Slice kTrunk[] = {
    {-0.04f, 0.074f, 0.098f}, {0.06f, 0.073f, 0.100f}, {0.16f, 0.062f, 0.097f},
    {0.26f, 0.049f, 0.090f},  {0.36f, 0.040f, 0.085f}, {0.46f, 0.035f, 0.082f},
    {0.56f, 0.039f, 0.085f},  {0.66f, 0.048f, 0.088f}, {0.75f, 0.055f, 0.088f},
    {0.83f, 0.058f, 0.082f},  {0.90f, 0.056f, 0.073f}, {0.97f, 0.042f, 0.060f},
};

void fitTrunk(const Body& body, const Landmarks& m, Fitter& fit) {
  const float s = m.size;
  // A narrow rig has narrow ribs; its hips are its own.
  const float ribs = std::clamp(m.halfShoulders() / (0.165f * s), 0.7f, 1.2f);
  for (const Slice& slice : kTrunk) {
    const glm::vec3 middle = m.trunk(slice.height);
    const glm::vec3 x(slice.x * s * glm::mix(1.0f, ribs, std::clamp(slice.height, 0.0f, 1.0f)), 0,
                      0);
    fit.add(trunkJointAt(body, middle), middle - x, middle + x, slice.radius * s);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const float x = (side == 0 ? 1.0f : -1.0f) * s;
    const glm::vec3 bust = m.trunk(0.73f) + glm::vec3(0.066f * x * ribs, 0, 0.050f * s);
    fit.add(trunkJointAt(body, bust), bust, bust, 0.064f * s);
    const glm::vec3 seat = m.trunk(-0.02f) + glm::vec3(0.07f * x, 0, -0.042f * s);
    fit.add(body.map.hips, seat, seat, 0.088f * s);
  }
}

void fitNeckAndShoulders(const Body& body, const Landmarks& m, Fitter& fit) {
  const float s = m.size;
  const int chest = body.map.chest, neck = body.map.neck;
  // Up to a little under the head's joint: its round end stays inside the skull.
  const glm::vec3 top = glm::mix(m.neck, m.head, 0.9f);
  fit.add(neck, m.neck - glm::vec3(0, 0.02f * s, 0), neck, top, 0.052f * s);
  for (std::size_t side = 0; side < 2; ++side) {
    const float x = side == 0 ? 1.0f : -1.0f;
    const int collar = body.map.collar[side] >= 0 ? body.map.collar[side] : chest;
    const glm::vec3 shoulder = m.shoulder[side];
    // Trapezius: from the side of the neck down to the tip of the shoulder.
    const glm::vec3 inner = m.neck + glm::vec3(0.03f * x * s, 0.004f * s, 0);
    const glm::vec3 mid = glm::mix(inner, shoulder, 0.5f) + glm::vec3(0, 0.002f * s, 0);
    fit.add(chest, inner, collar, mid, 0.047f * s);
    fit.add(collar, mid, collar, shoulder, 0.052f * s);
    // Chest to armpit.
    const glm::vec3 breast = m.trunk(0.84f) + glm::vec3(0.05f * x * s, 0, 0.01f * s);
    fit.add(chest, breast, collar, glm::mix(breast, shoulder, 0.8f) - glm::vec3(0, 0.012f * s, 0),
            0.064f * s);
  }
}

void fitLimbs(const Body& body, const Landmarks& m, Fitter& fit) {
  const float s = m.size;
  for (std::size_t side = 0; side < 2; ++side) {
    const int upper = body.map.upperArm[side], fore = body.map.foreArm[side];
    const glm::vec3 shoulder = m.shoulder[side], elbow = m.elbow[side], wrist = m.wrist[side];
    fit.add(upper, shoulder, glm::mix(shoulder, elbow, 0.45f), 0.05f * s);
    fit.add(upper, glm::mix(shoulder, elbow, 0.45f), elbow, 0.041f * s, true);
    fit.add(fore, elbow, glm::mix(elbow, wrist, 0.5f), 0.04f * s, true);
    fit.add(fore, glm::mix(elbow, wrist, 0.5f), wrist, 0.033f * s, true);
    fit.add(body.map.hand[side], wrist, m.fingertips[side] - 0.2f * (m.fingertips[side] - wrist),
            0.038f * s, true);

    const int thigh = body.map.thigh[side], shin = body.map.shin[side];
    const glm::vec3 hip = m.hip[side], knee = m.knee[side], ankle = m.ankle[side];
    fit.add(thigh, hip, glm::mix(hip, knee, 0.5f), 0.086f * s);
    fit.add(thigh, glm::mix(hip, knee, 0.5f), knee, 0.066f * s);
    const glm::vec3 calf = glm::mix(knee, ankle, 0.4f) - glm::vec3(0, 0, 0.012f * s);
    fit.add(shin, knee, calf, 0.057f * s);
    fit.add(shin, calf, ankle, 0.047f * s);
    fit.add(body.map.foot[side], m.heel[side], m.ball[side], 0.038f * s);
    fit.add(m.toes[side], m.ball[side], m.toe[side], 0.03f * s);
  }
}

/// Every bone as thick as a fifth of its length, but the head's.
void fitAnything(Body& body) {
  const Skeleton& skeleton = body.skeleton;
  for (std::size_t j = 0; j < skeleton.jointCount(); ++j) {
    const int parent = skeleton.parents[j];
    bool ofHead = false;
    for (int up = parent; up >= 0; up = skeleton.parents[index(up)]) ofHead |= up == body.map.head;
    const float length = glm::length(skeleton.offsets[j]);
    if (parent < 0 || ofHead || length < 0.02f) continue;
    // Towards the head a bone stops short, so that its round end stays inside.
    const float end = static_cast<int>(j) == body.map.head ? 0.8f : 1.0f;
    body.capsules.push_back({parent, parent, glm::vec3(0), end * skeleton.offsets[j],
                             std::clamp(0.2f * length, 0.02f, 0.12f), false});
  }
}

}  // namespace

void fitCapsules(Body& body) {
  body.capsules.clear();
  if (!body.map.complete()) return fitAnything(body);
  const Landmarks marks = landmarksOf(body);
  Fitter fit(body);
  fitTrunk(body, marks, fit);
  fitNeckAndShoulders(body, marks, fit);
  fitLimbs(body, marks, fit);
}

namespace {

bool isTrunk(const Body& body, const BodyCapsule& capsule) {
  const BodyMap& map = body.map;
  const auto is = [&](int joint) {
    return joint == map.hips || joint == map.chest || joint == map.neck ||
           std::find(map.spine.begin(), map.spine.end(), joint) != map.spine.end();
  };
  return is(capsule.jointA) && is(capsule.jointB);
}

}  // namespace

void placeCapsules(const Body& body, std::span<const RigidTransform> worldFromJoint,
                   std::span<Capsule> out) {
  for (std::size_t c = 0; c < body.capsules.size(); ++c) {
    const BodyCapsule& capsule = body.capsules[c];
    out[c] = {worldFromJoint[index(capsule.jointA)].point(capsule.a),
              worldFromJoint[index(capsule.jointB)].point(capsule.b), capsule.radius};
  }
}

void makeRoomForHair(const Body& body, const RigidTransform& worldFromHead,
                     std::span<Capsule> capsules) {
  constexpr float kRoom = 0.008f, kLeast = 0.25f;
  // The scalp, as two spheres.
  const float s = body.size;
  const glm::vec3 skull = worldFromHead.point(s * glm::vec3(0, 0.115f, -0.01f));
  const glm::vec3 face = worldFromHead.point(s * glm::vec3(0, 0.06f, 0.03f));
  const Capsule head[] = {{skull, skull, 0.092f * s}, {face, face, 0.078f * s}};
  for (std::size_t c = 0; c < capsules.size(); ++c) {
    if (!body.capsules[c].yields) continue;
    float room = capsules[c].radius;
    const auto leave = [&](const Capsule& other) {
      room = std::min(room, axisDistance(capsules[c], other) - other.radius - kRoom);
    };
    for (const Capsule& ball : head) leave(ball);
    for (std::size_t o = 0; o < capsules.size(); ++o)
      // Legs and the upper arms' roots, which an arm cannot come away from, do not count.
      if (!body.capsules[o].yields && isTrunk(body, body.capsules[o])) leave(capsules[o]);
    capsules[c].radius = std::max(room, kLeast * capsules[c].radius);
  }
}

}  // namespace hair

#include <libhair/motion/dance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include <libhair/core/rotations.h>
#include <libhair/motion/dance_curves.h>
#include <libhair/motion/dance_score.h>

// Makes a clip from the score: every column is a curve through its keys, smoothed over a few
// frames. The score gives hips and feet; knees follow by two-bone inverse kinematics in the plane
// of the knee; the hips are lowered where a leg is too short. Arms point in given directions; the
// bend of the spine is distributed over three joints.

namespace hair {
namespace {

using score::beatOf;
using score::Curve;
using score::kBeats;
using score::kFrames;
using score::kSeconds;
using score::smoothed;
using score::throughKeys;

constexpr float kPi = 3.14159265f;
constexpr float kRound = 720.0f;  ///< degrees that the dancer turns in one loop

enum Joint : std::uint8_t {
  kHips,
  kSpine,
  kSpine1,
  kChest,
  kNeck,
  kHead,
  kLeftShoulder,
  kLeftArm,
  kLeftForeArm,
  kLeftHand,
  kRightShoulder,
  kRightArm,
  kRightForeArm,
  kRightHand,
  kLeftUpLeg,
  kLeftLeg,
  kLeftFoot,
  kLeftToeBase,
  kRightUpLeg,
  kRightLeg,
  kRightFoot,
  kRightToeBase,
  kJointCount
};

constexpr float kThigh = 0.40f, kShin = 0.395f;
constexpr glm::vec3 kHipJoint(0.088f, -0.03f, 0.0f);     ///< left, from the hips
constexpr glm::vec3 kBall(0.0f, -0.055f, 0.115f);        ///< from the ankle
constexpr float kBallHeight = 0.02f, kStanding = 0.90f;  ///< of ball and hips over the floor

glm::quat about(glm::vec3 axis, float degrees) {
  return glm::angleAxis(glm::radians(degrees), axis);
}

/// Nod forward, lean right, turn left: the last is outermost.
glm::quat bent(float forward, float right, float left) {
  return about({0, 1, 0}, left) * about({0, 0, 1}, right) * about({1, 0, 0}, forward);
}

/// Shortest rotation from one unit vector to another; not for opposite ones.
glm::quat arc(glm::vec3 from, glm::vec3 to) {
  return glm::normalize(glm::quat(1.0f + glm::dot(from, to), glm::cross(from, to)));
}

Curve curveOf(std::span<const score::Key> keys, float gain = 0.0f) {
  return smoothed(throughKeys(keys, [](const score::Key& k) { return k.value; }, gain), gain);
}

struct FootTrack {
  Curve x, y, z, yaw, pitch;  ///< of the ball
};

float smoothstep5(float s) {
  return s * s * s * (s * (6.0f * s - 15.0f) + 10.0f);
}

FootTrack footTrack(std::span<const score::Plant> plants, const Curve& heading) {
  FootTrack track{Curve(kFrames), Curve(kFrames), Curve(kFrames), Curve(kFrames), Curve(kFrames)};
  const std::size_t count = plants.size();
  for (std::size_t p = 0; p < count; ++p) {
    const score::Plant& plant = plants[p];
    score::Plant next = plants[(p + 1) % count];
    if (p + 1 == count) {
      next.from += static_cast<float>(kBeats);
      next.to += static_cast<float>(kBeats);
      next.yawFrom += kRound;
    }
    const auto frameAt = [](float beat) {
      return static_cast<std::ptrdiff_t>(std::ceil(static_cast<double>(beat) * kFrames / kBeats));
    };
    // A foot that pivots follows the body's heading and never turns back.
    float ahead = -1e9f;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, frameAt(plant.from));
         i < std::min<std::ptrdiff_t>(kFrames, frameAt(plant.to)); ++i)
      ahead = std::max(ahead, heading[static_cast<std::size_t>(i)]);
    float yaw = plant.yawFrom;
    for (std::ptrdiff_t i = frameAt(plant.from); i < frameAt(next.from); ++i) {
      constexpr auto n = static_cast<std::ptrdiff_t>(kFrames);
      const std::ptrdiff_t round = i < 0 ? -1 : i / n;
      const auto f = static_cast<std::size_t>(i - round * n);
      const auto beat = static_cast<float>(static_cast<double>(i) * kBeats / kFrames);
      if (beat < plant.to) {
        const bool pivots = plant.yawTo > plant.yawFrom + 5.0f;
        if (pivots) yaw = std::clamp(heading[f] + plant.yawTo - ahead, yaw, plant.yawTo);
        track.x[f] = plant.x;
        track.y[f] = kBallHeight;
        track.z[f] = plant.z;
        track.yaw[f] = yaw;
        track.pitch[f] = plant.pitch;
      } else {
        const float s = (beat - plant.to) / (next.from - plant.to);
        const float w = smoothstep5(s), hump = 16.0f * s * s * (1.0f - s) * (1.0f - s);
        track.x[f] = glm::mix(plant.x, next.x, w);
        track.y[f] = kBallHeight + plant.lift * hump;
        track.z[f] = glm::mix(plant.z, next.z, w);
        track.yaw[f] = glm::mix(yaw, next.yawFrom, w);
        track.pitch[f] = glm::mix(plant.pitch, next.pitch, w) + 24.0f * hump * (1.0f - s);
      }
      track.yaw[f] -= kRound * static_cast<float>(round);
    }
  }
  track.yaw = smoothed(track.yaw, kRound, 5);
  track.pitch = smoothed(track.pitch, 0.0f, 5);
  return track;
}

struct DirectionCurve {
  std::array<Curve, 3> axis;
  glm::vec3 operator[](std::size_t f) const {
    return glm::normalize(glm::vec3(axis[0][f], axis[1][f], axis[2][f]));
  }
};

DirectionCurve directions(std::span<const score::DirectionKey> keys) {
  DirectionCurve out;
  for (int a = 0; a < 3; ++a)
    out.axis[static_cast<std::size_t>(a)] = smoothed(throughKeys(
        keys, [a](const score::DirectionKey& k) { return glm::normalize(k.direction)[a]; }, 0.0f));
  return out;
}

struct Foot {
  glm::vec3 ball;
  float yaw, pitch, passe;
};

/// All that a pose is made of; degrees, metres.
struct Stance {
  glm::vec3 hips;
  float heading, hipPitch, hipRoll, bend, lean, twist, nod, tilt, turn;
  std::array<Foot, 2> feet;
  std::array<glm::vec3, 2> upper, fore;  ///< chest frame, unit, x away from the middle
};

glm::quat pelvisOf(const Stance& s) {
  return bent(s.hipPitch, s.hipRoll, s.heading);
}
float sign(std::size_t side) {
  return side == 0 ? 1.0f : -1.0f;
}
glm::vec3 hipJoint(std::size_t side) {
  return kHipJoint * glm::vec3(sign(side), 1, 1);
}
glm::quat footTurn(const Foot& foot) {
  return about({0, 1, 0}, foot.yaw) * about({1, 0, 0}, foot.pitch);
}

/// Highest place of the hips at which both feet reach the floor.
float reachableHips(const Stance& s) {
  float height = s.hips.y;
  const glm::quat pelvis = pelvisOf(s);
  for (std::size_t side = 0; side < 2; ++side) {
    const Foot& foot = s.feet[side];
    const glm::vec3 ankle = foot.ball - footTurn(foot) * kBall;
    const glm::vec3 hip = pelvis * hipJoint(side);
    const glm::vec2 away(s.hips.x + hip.x - ankle.x, s.hips.z + hip.z - ankle.z);
    constexpr float leg = 0.985f * (kThigh + kShin);
    const float reach =
        ankle.y + std::sqrt(std::max(0.01f, leg * leg - glm::dot(away, away))) - hip.y;
    height = std::min(height, glm::mix(reach, 10.0f, foot.passe));
  }
  return height;
}

/// Local rotations of a stance, [kJointCount].
void pose(const Stance& s, std::span<glm::quat> local) {
  std::fill(local.begin(), local.end(), glm::quat(1, 0, 0, 0));
  const glm::quat pelvis = pelvisOf(s);
  local[kHips] = pelvis;
  const glm::quat third = bent(s.bend / 3.0f, s.lean / 3.0f, s.twist / 3.0f);
  local[kSpine] = local[kSpine1] = local[kChest] = third;
  local[kNeck] = bent(0.4f * s.nod, 0.4f * s.tilt, 0.4f * s.turn);
  local[kHead] = bent(0.6f * s.nod, 0.6f * s.tilt, 0.6f * s.turn);

  for (std::size_t side = 0; side < 2; ++side) {
    const glm::vec3 mirror(sign(side), 1, 1), out(sign(side), 0, 0);
    const std::size_t collar = side == 0 ? kLeftShoulder : kRightShoulder;
    const glm::vec3 upper = s.upper[side] * mirror, fore = s.fore[side] * mirror;
    // The shoulder blade goes up with the arm.
    const float raised = glm::smoothstep(-0.3f, 1.0f, upper.y);
    local[collar] = about({0, 0, 1}, sign(side) * 20.0f * raised);
    const glm::quat upperTurn = arc(out, upper);
    local[collar + 1] = glm::conjugate(local[collar]) * upperTurn;
    local[collar + 2] = glm::conjugate(upperTurn) * arc(upper, fore) * upperTurn;

    const std::size_t leg = side == 0 ? kLeftUpLeg : kRightUpLeg;
    const Foot& foot = s.feet[side];
    const glm::vec3 hip = s.hips + pelvis * hipJoint(side);
    // Drawn up: ankle beside the other knee, toes down, knee to the side.
    const glm::quat drawnTurn =
        pelvis * about({0, 1, 0}, -55.0f * sign(side)) * about({1, 0, 0}, 50.0f);
    const glm::vec3 drawn = s.hips + pelvis * glm::vec3(0.02f * sign(side), -0.36f, 0.07f);
    const glm::quat turn = glm::slerp(footTurn(foot), drawnTurn, foot.passe);
    const glm::vec3 ankle = glm::mix(foot.ball - footTurn(foot) * kBall, drawn, foot.passe);
    const float reach = std::min(glm::distance(hip, ankle), 0.9995f * (kThigh + kShin));
    const glm::vec3 down = glm::normalize(ankle - hip);
    glm::vec3 pole = 0.65f * (about({0, 1, 0}, foot.yaw) * glm::vec3(0, 0, 1)) +
                     0.35f * (pelvis * glm::vec3(0, 0, 1));
    pole = glm::mix(pole, pelvis * glm::vec3(0.9f * sign(side), 0, 0.45f), foot.passe);
    pole = glm::normalize(pole - glm::dot(pole, down) * down);
    // Cosine law: how far the thigh leans from the line to the ankle.
    const float c = (kThigh * kThigh + reach * reach - kShin * kShin) / (2.0f * kThigh * reach);
    const glm::vec3 thigh = c * down + std::sqrt(std::max(0.0f, 1.0f - c * c)) * pole;
    const glm::vec3 shin = (reach * down - kThigh * thigh) / kShin;
    const glm::vec3 left = glm::normalize(glm::cross(pole, down));
    const glm::quat thighTurn = rotationFromUpFront(-thigh, glm::cross(left, -thigh));
    const glm::quat shinTurn = rotationFromUpFront(-shin, glm::cross(left, -shin));
    local[leg] = glm::conjugate(pelvis) * thighTurn;
    local[leg + 1] = glm::conjugate(thighTurn) * shinTurn;
    local[leg + 2] = glm::conjugate(shinTurn) * turn;
    local[leg + 3] = about({1, 0, 0}, -foot.pitch * (1.0f - foot.passe));
  }
}

void addFrame(Clip& clip, const Stance& stance) {
  std::array<glm::quat, kJointCount> local;
  pose(stance, local);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    clip.rotations.push_back(glm::normalize(local[j]));
    clip.positions.push_back(j == kHips ? stance.hips : clip.skeleton.offsets[j]);
  }
}

Clip wholeRound() {
  const score::Score& s = score::dance();
  const Curve heading = curveOf(s.heading, kRound);
  const Curve x = curveOf(s.x), z = curveOf(s.z), drop = curveOf(s.drop),
              bounce = curveOf(s.bounce);
  const Curve hipPitch = curveOf(s.hipPitch), hipRoll = curveOf(s.hipRoll);
  const Curve bend = curveOf(s.bend), lean = curveOf(s.lean), twist = curveOf(s.twist);
  const Curve nod = curveOf(s.nod), tilt = curveOf(s.tilt), turn = curveOf(s.turn);
  std::array<FootTrack, 2> feet;
  std::array<Curve, 2> passe;
  std::array<DirectionCurve, 2> upper, fore;
  for (std::size_t side = 0; side < 2; ++side) {
    feet[side] = footTrack(s.feet[side], heading);
    passe[side] = curveOf(s.passe[side]);
    upper[side] = directions(s.arms[side].upper);
    fore[side] = directions(s.arms[side].fore);
  }
  std::vector<Stance> stances(kFrames);
  Curve height(kFrames);
  for (std::size_t f = 0; f < kFrames; ++f) {
    // Down on the beat, up between: a bounce of 2 cm.
    const auto beat = static_cast<float>(beatOf(f));
    const float down = 0.01f * bounce[f] * (1.0f + std::cos(2.0f * kPi * beat));
    Stance& stance = stances[f];
    stance = {{x[f], kStanding - drop[f] - down, z[f]},
              heading[f],
              hipPitch[f],
              hipRoll[f],
              bend[f],
              lean[f],
              twist[f],
              nod[f],
              tilt[f],
              turn[f],
              {},
              {upper[0][f], upper[1][f]},
              {fore[0][f], fore[1][f]}};
    for (std::size_t side = 0; side < 2; ++side) {
      const FootTrack& t = feet[side];
      stance.feet[side] = {{t.x[f], t.y[f], t.z[f]}, t.yaw[f], t.pitch[f], passe[side][f]};
    }
    // In the spin the standing heel is off the floor.
    stance.feet[0].pitch += 34.0f * passe[1][f];
    height[f] = reachableHips(stance);
  }
  height = smoothed(height);

  Clip clip;
  clip.skeleton = dancerSkeleton();
  clip.frameTime = kSeconds / kFrames;
  for (std::size_t f = 0; f <= kFrames; ++f) {
    Stance& stance = stances[f % kFrames];
    stance.hips.y = height[f % kFrames];
    addFrame(clip, stance);
  }
  return clip;
}

}  // namespace

Skeleton dancerSkeleton() {
  Skeleton s;
  const auto add = [&](const char* name, int parent, glm::vec3 offset,
                       glm::vec3 tip = glm::vec3(0)) {
    s.names.emplace_back(name);
    s.parents.push_back(parent);
    s.offsets.push_back(offset);
    s.tips.push_back(tip);
  };
  add("Hips", -1, {0, kStanding, 0});
  add("Spine", kHips, {0, 0.08f, -0.01f});
  add("Spine1", kSpine, {0, 0.12f, 0});
  add("Chest", kSpine1, {0, 0.13f, 0});
  add("Neck", kChest, {0, 0.19f, -0.015f});
  add("Head", kNeck, {0, 0.095f, 0.015f}, {0, 0.165f, 0});
  for (std::size_t side = 0; side < 2; ++side) {
    const float x = sign(side);
    const bool left = side == 0;
    const int collar = left ? kLeftShoulder : kRightShoulder;
    add(left ? "LeftShoulder" : "RightShoulder", kChest, {0.03f * x, 0.14f, 0.0f});
    add(left ? "LeftArm" : "RightArm", collar, {0.132f * x, -0.012f, -0.01f});
    add(left ? "LeftForeArm" : "RightForeArm", collar + 1, {0.28f * x, 0, 0});
    add(left ? "LeftHand" : "RightHand", collar + 2, {0.24f * x, 0, 0}, {0.17f * x, 0, 0});
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const bool left = side == 0;
    const int leg = left ? kLeftUpLeg : kRightUpLeg;
    add(left ? "LeftUpLeg" : "RightUpLeg", kHips, hipJoint(side));
    add(left ? "LeftLeg" : "RightLeg", leg, {0, -kThigh, 0});
    add(left ? "LeftFoot" : "RightFoot", leg + 1, {0, -kShin, 0});
    add(left ? "LeftToeBase" : "RightToeBase", leg + 2, kBall, {0, -0.005f, 0.06f});
  }
  return s;
}

Clip danceClip(double frameTime) {
  const Clip clip = wholeRound();
  return frameTime == clip.frameTime ? clip : resample(clip, frameTime);
}

Clip stillClip() {
  Stance stance{};
  stance.hips = {0, kStanding - 0.012f, 0};
  for (std::size_t side = 0; side < 2; ++side) {
    stance.feet[side] = {{0.1f * sign(side), kBallHeight, 0.105f}, 9.0f * sign(side), 0, 0};
    stance.upper[side] = glm::normalize(glm::vec3(0.3f, -0.95f, -0.03f));
    stance.fore[side] = glm::normalize(glm::vec3(0.1f, -0.95f, 0.25f));
  }
  Clip clip;
  clip.skeleton = dancerSkeleton();
  addFrame(clip, stance);
  return clip;
}

}  // namespace hair

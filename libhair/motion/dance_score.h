#pragma once

#include <span>

#include <glm/glm.hpp>

namespace hair::score {

/// The keyframes of the built-in dance. Time in beats, kBeats of them in kSeconds; angles in
/// degrees, lengths in metres. Floor: x to the dancer's left at the start, z to the front.
constexpr double kSeconds = 15.0;
constexpr double kBeats = 32.0;  ///< 128 beats a minute

struct Key {
  float beat, value;
};
struct DirectionKey {
  float beat;
  glm::vec3 direction;  ///< chest frame: x away from the body's middle, y up, z front; any length
};

/// The ball of a foot stands at (x, z) from beat `from` to beat `to`; there the foot turns from
/// yawFrom to yawTo, and stands `pitch` degrees on its toes. Between two plants it swings.
struct Plant {
  float from, to;
  float x, z;
  float yawFrom, yawTo;
  float pitch;
  float lift;  ///< height of the swing that follows
};

struct Arm {
  std::span<const DirectionKey> upper, fore;
};

struct Score {
  // Hips
  std::span<const Key> x, z, drop, heading;  ///< heading: turns of the whole body, to the left
  std::span<const Key> bounce;               ///< how much of the beat's bounce, 0 to 1
  std::span<const Key> hipPitch, hipRoll;    ///< forward, to the right
  // Trunk, distributed over the spine; then neck and head
  std::span<const Key> bend, lean, twist;  ///< forward, to the right, to the left
  std::span<const Key> nod, tilt, turn;    ///< forward, to the right, to the left
  std::span<const Plant> feet[2];
  std::span<const Key> passe[2];  ///< 1: the foot is drawn up to the other knee
  Arm arms[2];
};

const Score& dance();

}  // namespace hair::score

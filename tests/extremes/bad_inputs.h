#pragma once

#include <vector>

#include <libhair/simulation/frame.h>

namespace hair::extremes {

/// Everything that a caller hands over: before the hair is made, and in each frame.
struct Inputs {
  Groom groom;
  WispSettings wisps;
  FrameSettings settings;
  RigidTransform head;
  std::vector<Capsule> capsules;
  float seconds = 0;
  glm::vec3 push{0};  ///< added to what pushes one guide point, m/s²

  BodyState body() const { return {head, capsules}; }
};

/// A number among them.
struct BadInput {
  const char* name;
  bool atStart;  ///< there from the start on; else in one frame only
  float& (*of)(Inputs&);
};
const std::vector<BadInput>& badInputs();
const BadInput& badInput(const char* name);

/// What no number should be.
struct BadValue {
  const char* name;
  float value;
};
const std::vector<BadValue>& badValues();

}  // namespace hair::extremes

#pragma once

#include <cstdint>
#include <vector>

#include <libhair/simulation/frame.h>

namespace hair::extremes {

/// What stands around the head.
enum class Body {
  None,
  Ball,        ///< beside the strands, in reach
  Overlap,     ///< four capsules, one in the other
  Shrinking,   ///< to a point, and to a capsule without thickness
  Swallowing,  ///< grows over the roots
  Shot,        ///< flies through at 300 m/s
  Crowd,       ///< as many as there may be, in a heap
};

/// How the head moves while hair is disturbed, beside standing still.
struct HeadMotion {
  float spin = 0;          ///< rad/s
  bool reversing = false;  ///< the other way round in every frame
  float jump = 0;          ///< metres, in the third frame, or there and back in all if `reversing`
};

/// One combination of extremes: what its values make of the defaults.
struct Setup {
  float frame = 1.0f / 60;  ///< seconds
  int substeps = 0;         ///< a frame; 0: as GuideSettings::substep says
  float gravity = 9.81f;
  bool anyGravity = false, reversingGravity = false;
  HeadMotion motion;
  float longestLink = 0.02f, ratio = 1;  ///< metres; of neighbouring links
  std::uint32_t links = 15;
  std::uint32_t strands = 17;
  float spread = 0.1f;  ///< metres; radius of the ball on which roots are
  Body body = Body::None;
  glm::vec3 place{0};  ///< where the head is, metres
  FrameSettings settings;
  const char* badField = nullptr;  ///< of badInputs()
  float badValue = 0;
  bool refused = false;  ///< must be, whatever the rest is
};

/// A value of a dimension; the first one of each is the ordinary.
struct Value {
  const char* name;
  void (*apply)(Setup&);
};
struct Dimension {
  const char* name;
  std::vector<Value> values;
  std::size_t refused = 0;  ///< so many of the last values are refused, whatever the others are

  bool refuses(std::size_t value) const { return value + refused >= values.size(); }
};
const std::vector<Dimension>& dimensions();

/// Combination `number` of those that a seed makes: for each dimension which of its values it has,
/// then which bad input and its value. In every third something is wrong (a bad input, or a value
/// that is always refused) in a scene that is ordinary else. Of the others half are ordinary in
/// each dimension but one or two, half in six of ten.
bool wrongOnPurpose(std::uint32_t number);
std::vector<std::size_t> draw(std::uint32_t number, std::uint32_t seed);
Setup setupOf(const std::vector<std::size_t>& values);

}  // namespace hair::extremes

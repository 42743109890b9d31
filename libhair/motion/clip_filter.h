#pragma once

#include <cstddef>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/motion/skeleton.h>

namespace HAIR_API hair {

/// What counts as a flip.
struct FlipSettings {
  float minDegrees = 1.2f;  ///< a jump smaller than this is never a flip
  float ratio = 3.0f;       ///< how far it must stand out against the motion around it
  int maxFrames = 2;        ///< longest flip, frames
};

/// A joint that for one or two frames jumped away and came back.
struct Flip {
  std::size_t joint;  ///< that jumped
  std::size_t frame;  ///< first bad frame
  int frames;         ///< how many
  float degrees;      ///< from where the joint should have been
};

/// Finds flips (a joint's rotation leaves its path and returns to it within maxFrames) and replaces
/// them by interpolation between the good frames at both sides. Fast motion that goes on is kept,
/// and so are jumps that stay. The first and last two frames are not judged.
std::vector<Flip> removeFlips(Clip& clip, const FlipSettings& settings = {});

}  // namespace hair

#pragma once

#include <cstddef>
#include <vector>

#include <libhair/motion/motion.h>

namespace hair {

/// Finds flips (a joint's rotation leaves its path and returns to it within maxFrames) and replaces
/// them by interpolation between the good frames at both sides. Fast motion that goes on is kept,
/// and so are jumps that stay. The first and last two frames are not judged.
std::vector<Flip> removeFlips(Clip& clip, const FlipSettings& settings = {});

}  // namespace hair

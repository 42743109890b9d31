#pragma once

#include <apps/common/player.h>
#include <libhair/measure/motion/scene.h>

namespace hair {

/// A character and its motion, as the measurements of the library take it. Throws Error where the
/// motion ends before `frames` do: hair on a body that has stopped is no measure of motion.
MeasuredScene measuredScene(const Character& character, const PlayerOptions& options, int frames);

}  // namespace hair

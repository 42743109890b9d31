#pragma once

#include <libhair/motion/motion.h>

namespace hair {

/// The skeleton of the built-in dancer: a woman of 1.68 m, zero pose a T that faces +Z.
Skeleton dancerSkeleton();

/// The built-in dance: about 15 s on a beat: steps, turns, nods, leans, a hair flip, a spin of one
/// and a half turns with its wind-up and follow-through, a bow. Ends as it starts: loops.
Clip danceClip(double frameTime = 1.0 / 120.0);

/// The dancer standing at ease: one frame.
Clip stillClip();

}  // namespace hair

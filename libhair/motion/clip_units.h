#pragma once

#include <libhair/motion/motion.h>

namespace hair {

/// clipFromBvh in the file's unit of length.
Clip clipInFileUnits(const Bvh& bvh);

/// Turns the unit of length of a clip into metres. Throws Error for joints beyond 1000 km.
void toMetres(Clip& clip, float scale);

}  // namespace hair

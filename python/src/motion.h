#pragma once

#include <memory>
#include <vector>

#include <libhair/motion/motion.h>

#include "arrays.h"

namespace hair::python {

using PosePtr = std::shared_ptr<BodyPose>;

/// [C, 7] float32: a, b, radius.
static_assert(sizeof(Capsule) == 7 * sizeof(float));

}  // namespace hair::python

#pragma once

#include <apps/common/performance.h>
#include <libhair/measure/motion/scene.h>

namespace hair {

/// The performance of a subject, as the measurements of the library take it. Throws Error where the
/// motion ends before `frames` do: hair on a body that has stopped is no measure of motion.
MeasuredScene measuredScene(const Subject& subject, const PerformanceOptions& options, int frames);

}  // namespace hair

#pragma once

#include <span>
#include <string>
#include <vector>

#include <libhair/measure/shadow/shadow_trial.h>

namespace hair {

/// Error against time, both logarithmic: a marker a trial, whiskers of one standard error, the
/// Pareto front as a line, its trials named. `front` indexes `trials` (trialFront). An SVG element.
std::string errorTimePlot(std::span<const ShadowTrial> trials, std::span<const std::size_t> front,
                          std::size_t pointCount);

}  // namespace hair

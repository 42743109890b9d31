#pragma once

#include <string>

#include <libhair/measure/motion/simulation_trial.h>

namespace hair {

/// Two panels over the guides' time, all logarithmic: how far tips are from the converged run, and
/// the greatest stretch. A line over the substeps, one over the iterations of relaxation, its
/// settings named; dashed: what the reference itself is uncertain by. An SVG element.
std::string motionPlot(const SubstepTrial& trial);

}  // namespace hair

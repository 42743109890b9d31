#pragma once

#include <string>

#include <apps/hair/measure/measure_report.h>

namespace hair {

/// Transmittance along case.ray: a panel a method with the truth behind all its settings, the most
/// accurate setting bold. An SVG element.
std::string visibilityPlot(const MeasuredCase& measured);

}  // namespace hair

#pragma once

#include <string>

#include <apps/hair/measure/measure_report.h>

namespace hair {

/// The sample points seen at right angles to the light, +Y up: coloured by the truth, and by how
/// far the most accurate setting of each method is from it. An SVG element.
std::string differencePictures(const MeasureReport& report, const MeasuredCase& measured);

}  // namespace hair

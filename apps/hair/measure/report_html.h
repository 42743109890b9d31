#pragma once

#include <iosfwd>

#include <apps/hair/measure/measure_report.h>

namespace hair {

/// The report of a run as one page that needs nothing else: no scripts, no links, pictures inside.
/// For each light and footprint: error against time, table, visibility along a ray, differences
/// from the truth, flicker; then how to repeat it.
void writeHtml(const MeasureReport& report, std::ostream& out);

}  // namespace hair

#pragma once

#include <iosfwd>

#include <apps/hair/measure/measure_report.h>

namespace hair {

/// For people: a row a method and setting, front rows marked, then flicker.
void printTable(const MeasureReport& report, const MeasuredCase& measured, std::ostream& out);

/// A row a method and setting, light and footprint; kCsvHeader names the columns. Errors have 9
/// digits, so that they are the same bits when they are the same. Flicker is empty where it was not
/// measured. Settings that failed are left out.
void writeCsv(const MeasureReport& report, std::ostream& out);
inline constexpr const char* kCsvHeader =
    "light,light_x,light_y,light_z,footprint_m,method,settings,mean_abs,mean_abs_se,rms,rms_se,"
    "p99,p99_se,bias,bias_se,build_ms,sample_ms,sample_ns_per_point,bytes,pareto,shimmer,swim";

/// A row a sample point: strand,point,x,y,z,truth,truth_se, then a column a method and setting,
/// named by its label. Strand and point are the file's (MeasuredHair::origin), both counted from 0,
/// points over all strands. 9 digits: floats come back as they were.
void writeDump(const MeasureReport& report, const MeasuredCase& measured, std::ostream& out);

}  // namespace hair

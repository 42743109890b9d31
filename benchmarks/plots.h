#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace hair::bench {

/// One benchmark that ran: group/what/how, and its time.
struct Measured {
  std::string group, what, how;
  double milliseconds = 0, floor = 0;
};

/// Reports to the console, and remembers.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override;
  std::vector<Measured> measured;
};

/// GROUP.svg for every group: times over numbers, both logarithmic, where `how` is a number, beside
/// the floor; bars otherwise. Overwrites.
void writePlots(const std::vector<Measured>& measured, const std::filesystem::path& folder);

}  // namespace hair::bench

#pragma once

#include <iosfwd>
#include <string>

namespace hair::bench {

struct TargetOptions {
  std::string only;    ///< rows of the groups whose name has this word; empty: all
  bool quick = false;  ///< little work: whether the program works, not what the machine can do
};

/// CSV: row,measured,target,unit,ok. Before it comments (#): threads, instruction set, bandwidth,
/// state hashes. `ok` is yes, no, or why there is no figure. Medians, in one run; minutes.
void writeTargets(const TargetOptions& options, std::ostream& out);

}  // namespace hair::bench

#pragma once

#include <optional>
#include <set>
#include <string>

#include <apps/hair/commands.h>
#include <libhair/measure/shadow/choose.h>

namespace hair {

/// What the options of `hair measure` mean together, and whether they can be, before files are read
/// and rays are traced. All throw Error where they cannot.

/// All that is wrong with more than one option.
void checkOptions(const MeasureOptions& options);

/// --methods as ShadowCandidate::method has it: "deep-opacity-map,auto" to "deep opacity map",
/// "auto". None: all methods.
std::set<std::string> methodsWanted(const std::string& option);

/// What --max-error and --budget-ms ask for; none: nothing is to be chosen. Throws Error for limits
/// that are not positive.
std::optional<ShadowBudget> budgetOf(const MeasureOptions& options);

}  // namespace hair

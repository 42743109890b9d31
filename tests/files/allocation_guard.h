#pragma once

#include <cstddef>

namespace hair {

/// Largest single block that any thread asked operator new for since the last reset. The test
/// program replaces operator new for this.
std::size_t largestAllocation();
void resetLargestAllocation();

}  // namespace hair

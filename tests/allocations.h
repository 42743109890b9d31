#pragma once

#include <cstddef>

namespace hair::test {

/// What the threads of this program ask operator new for; a test program that has allocations.cpp
/// among its sources counts.
std::size_t allocationCount();
/// Largest single block since the last reset, bytes.
std::size_t largestAllocation();
void resetLargestAllocation();

}  // namespace hair::test

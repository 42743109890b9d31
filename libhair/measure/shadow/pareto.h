#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hair {

/// The Pareto front: indices of all (time, error) pairs that no other pair dominates, by rising
/// time (and so by falling error). A pair dominates another if it is no worse in both and better in
/// one; of equal pairs the first stays. Pairs that are not finite are never on the front. Throws
/// Error where `time` and `error` differ in size.
std::vector<std::size_t> paretoFront(std::span<const double> time, std::span<const double> error);

}  // namespace hair

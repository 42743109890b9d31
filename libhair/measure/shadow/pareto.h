#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hair {

/// Which of several ways are worth their cost: the indices of all (time, error) pairs that no other
/// pair beats, in order of rising time (and so of falling error). One pair beats another that it is
/// nowhere worse than and somewhere better; of equal pairs the first stays. Pairs that are not
/// finite are never on the front. `time` and `error` are of one size, else Error.
std::vector<std::size_t> paretoFront(std::span<const double> time, std::span<const double> error);

}  // namespace hair

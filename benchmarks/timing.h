#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace hair::bench {

/// Seconds of one call.
template <class Work>
double secondsOf(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median seconds of `repeats` calls, after one that warms up.
template <class Work>
double medianSeconds(int repeats, Work&& work) {
  work();
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) seconds.push_back(secondsOf(work));
  return median(std::move(seconds));
}

}  // namespace hair::bench

#pragma once

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <span>
#include <string_view>
#include <vector>

#include <libhair/core/strands.h>

namespace hair {

/// How commands say what a file holds: every line is a name and what there is to say.
inline std::ostream& row(std::string_view name) {
  return std::cout << std::left << std::setw(14) << name;
}

struct Quantiles {
  float least, median, most;
};
inline Quantiles quantiles(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

inline void printBounds(std::span<const glm::vec3> points) {
  const Bounds b = bounds(points);
  row("bounds") << "x " << b.lower.x << " .. " << b.upper.x << ", y " << b.lower.y << " .. "
                << b.upper.y << ", z " << b.lower.z << " .. " << b.upper.z << " m\n";
}

}  // namespace hair

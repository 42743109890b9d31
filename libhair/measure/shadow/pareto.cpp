#include <libhair/measure/shadow/pareto.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <libhair/core/error.h>

namespace hair {

std::vector<std::size_t> paretoFront(std::span<const double> time, std::span<const double> error) {
  require(time.size() == error.size(), "Pareto front: ", time.size(), " times but ", error.size(),
          " errors");
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (std::isfinite(time[i]) && std::isfinite(error[i])) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(time[a], error[a], a) < std::tuple(time[b], error[b], b);
  });
  // From the fastest on, whoever errs less than all before.
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(error[i] < least)) continue;
    least = error[i];
    front.push_back(i);
  }
  return front;
}

}  // namespace hair

#include <libhair/model/resample.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include <libhair/core/random.h>

namespace hair {

std::vector<std::uint32_t> chooseStrands(std::size_t total, std::size_t count) {
  std::vector<std::uint32_t> chosen(total);
  std::iota(chosen.begin(), chosen.end(), 0u);
  if (count >= total) return chosen;
  std::sort(chosen.begin(), chosen.end(), [](std::uint32_t a, std::uint32_t b) {
    return std::pair(hashWord(a), a) < std::pair(hashWord(b), b);
  });
  chosen.resize(count);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

ResamplePlan planResampling(StrandView strands, const std::vector<std::uint32_t>& chosen,
                            std::size_t pointsPerStrand) {
  ResamplePlan plan;
  for (std::uint32_t s : chosen) {
    const std::uint32_t begin = strands.first[s];
    const auto points = strands.strand(s);
    const std::size_t count = pointsPerStrand > 0 && !points.empty() ? pointsPerStrand : 0;
    if (count == 0)
      for (std::uint32_t i = 0; i < points.size(); ++i) plan.samples.push_back({begin + i, 0});
    const double step =
        count > 1 ? static_cast<double>(arcLength(points)) / static_cast<double>(count - 1) : 0.0;
    // Walk along the old segments; `before` is the length up to the start of segment i.
    std::uint32_t i = 0;
    double before = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double at = step * static_cast<double>(k);
      double segment = 0;
      for (; i + 1 < points.size(); ++i, before += segment) {
        segment = static_cast<double>(glm::distance(points[i], points[i + 1]));
        if (before + segment > at) break;
      }
      if (k + 1 == count) i = static_cast<std::uint32_t>(points.size() - 1);
      const bool inside = i + 1 < points.size();
      const double t = inside ? std::clamp((at - before) / segment, 0.0, 1.0) : 0.0;
      plan.samples.push_back({begin + i, static_cast<float>(t)});
    }
    plan.first.push_back(static_cast<std::uint32_t>(plan.samples.size()));
  }
  return plan;
}

}  // namespace hair

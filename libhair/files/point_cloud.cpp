#include <libhair/files/point_cloud.h>

#include <algorithm>

#include <libhair/core/error.h>

namespace hair {

std::size_t pointsPerStrandOf(std::span<const glm::vec3> points) {
  // A step is a jump if it is much longer than those before and after it.
  constexpr float kLonger = 2.5f;
  const std::size_t n = points.size();
  if (n < 4) return 0;
  std::vector<float> steps(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) steps[i] = glm::distance(points[i], points[i + 1]);
  std::vector<bool> jump(n - 1);
  std::size_t jumps = 0;
  for (std::size_t i = 1; i + 2 < n; ++i)
    if (steps[i] > kLonger * std::max(steps[i - 1], steps[i + 1])) {
      jump[i] = true;
      ++jumps;
    }
  // Of all divisors, the one whose ends of strands are the jumps: F-score of the two sets.
  std::size_t best = 0;
  double bestScore = 0.8;
  for (std::size_t each = 2; each <= n / 2; ++each) {
    if (n % each != 0) continue;
    const std::size_t ends = n / each - 1;
    std::size_t hits = 0;
    for (std::size_t i = each - 1; i + 1 < n; i += each) hits += jump[i];
    const double score = 2.0 * static_cast<double>(hits) / static_cast<double>(ends + jumps);
    if (score <= bestScore) continue;
    best = each;
    bestScore = score;
  }
  return best;
}

std::vector<std::uint32_t> cloudStrands(std::span<const glm::vec3> points, std::uint32_t asked,
                                        std::string_view name, std::vector<std::string>& notes) {
  std::size_t each = asked;
  if (asked > 0) {
    require(points.size() % asked == 0, name, ": ", points.size(), " points are no strands of ",
            asked, " points each (--points-per-strand)");
  } else {
    each = pointsPerStrandOf(points);
    require(
        each > 0, name, ": ", points.size(),
        " points without edges, and their spacing does not show where strands end; say how many "
        "points each has (--points-per-strand)");
    notes.push_back(text(each, " points a strand, as their spacing shows (--points-per-strand)"));
  }
  std::vector<std::uint32_t> first;
  for (std::size_t i = 0; i <= points.size(); i += each)
    first.push_back(static_cast<std::uint32_t>(i));
  return first;
}

}  // namespace hair

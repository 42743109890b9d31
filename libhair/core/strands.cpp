#include <libhair/core/strands.h>

#include <limits>

#include <libhair/core/error.h>

namespace hair {

std::size_t StrandSet::segmentCount() const {
  std::size_t count = 0;
  for (std::size_t s = 0; s < strandCount(); ++s) {
    const std::size_t n = first[s + 1] - first[s];
    count += n > 0 ? n - 1 : 0;
  }
  return count;
}

void StrandSet::append(std::span<const glm::vec3> strandPoints) {
  require(strandPoints.size() <= std::numeric_limits<std::uint32_t>::max() - points.size(),
          "strand set: more than 2^32 - 1 points; split it or draw fewer strands");
  points.insert(points.end(), strandPoints.begin(), strandPoints.end());
  first.push_back(static_cast<std::uint32_t>(points.size()));
}

void validate(StrandView strands, std::string_view name, std::size_t minPoints) {
  require(!strands.first.empty() && strands.first.front() == 0, name,
          ": strand offsets must start with 0");
  require(strands.first.back() == strands.pointCount(), name, ": strand offsets end at ",
          strands.first.back(), " but there are ", strands.pointCount(), " points");
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    // The end comes first: a later offset that decreases must not lead this one out of the points.
    require(
        strands.first[s] <= strands.first[s + 1] && strands.first[s + 1] <= strands.pointCount(),
        name, ": offsets of strand ", s, " decrease, or lead beyond the points");
    const auto points = strands.strand(s);
    require(points.size() >= minPoints, name, ": strand ", s, " has ", points.size(),
            " points, needs at least ", minPoints);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int c = 0; c < 3; ++c)
        // Written so that NaN fails too.
        require(std::abs(points[i][c]) < 1e8f, name, ": strand ", s, " point ", i, " is (",
                points[i].x, ", ", points[i].y, ", ", points[i].z,
                "): not finite, or beyond 1e8 m (check the scale)");
  }
}

float arcLength(std::span<const glm::vec3> points) {
  float length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

Bounds bounds(std::span<const glm::vec3> points) {
  Bounds b;
  for (glm::vec3 p : points) b.extend(p);
  return b;
}

}  // namespace hair

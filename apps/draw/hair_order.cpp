#include <apps/draw/hair_order.h>

#include <algorithm>

namespace hair::draw {

bool HairOrder::setTopology(std::span<const std::uint32_t> first) {
  if (std::ranges::equal(topology, first)) return false;
  topology.assign(first.begin(), first.end());
  segments.clear();
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    const std::uint32_t begin = first[s], end = first[s + 1];
    for (std::uint32_t i = begin; i + 1 < end; ++i) {
      segments.push_back({i > begin ? i - 1 : i, i, i + 1, i + 2 < end ? i + 2 : i + 1});
    }
  }
  return true;
}

void HairOrder::sort(std::span<const glm::vec3> points, glm::vec3 viewDirection) {
  constexpr std::uint32_t kSteps = 65536;
  depth.resize(points.size());
  float lower = INFINITY, upper = -INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float d = glm::dot(points[i], viewDirection);
    depth[i] = d;
    lower = std::min(lower, d), upper = std::max(upper, d);
  }

  // A counting sort: key 0 is the farthest.
  keys.resize(segments.size());
  counts.assign(kSteps + 1, 0);
  const float scale = upper > lower ? 0.5f * float(kSteps - 1) / (upper - lower) : 0.0f;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const float d = 2 * upper - depth[segments[s].y] - depth[segments[s].z];
    keys[s] = std::uint16_t(std::clamp(d * scale, 0.0f, float(kSteps - 1)));
    ++counts[keys[s] + 1u];
  }
  for (std::uint32_t k = 0; k < kSteps; ++k) counts[k + 1] += counts[k];
  order.resize(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) order[counts[keys[s]]++] = std::uint32_t(s);
}

void HairOrder::writeLines(std::vector<glm::uvec2>& lines) const {
  lines.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const glm::uvec4& s = segments[order[i]];
    lines[i] = {s.y, s.z};
  }
}

void HairOrder::writeRibbons(std::vector<glm::uvec4>& ribbons) const {
  ribbons.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ribbons[i] = segments[order[i]];
}

}  // namespace hair::draw

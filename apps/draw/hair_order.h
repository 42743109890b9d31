#pragma once

// Inside hair_draw only: segments from the farthest to the nearest.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair::draw {

/// Orders the segments of strands along the view, for blending. Hair is thinner than a pixel, so it
/// is drawn half transparent, and only blending from back to front gives each strand its share of
/// the pixel. Not depth writes without order (front strands drawn first hide the
/// ones behind: a bright fringe), nor alpha to coverage (strands of one opacity cover the same
/// samples and never add up to opaque; noise).
class HairOrder {
 public:
  /// Takes the strands' topology; cheap when it has not changed. True if it has.
  bool setTopology(std::span<const std::uint32_t> first);

  std::size_t segmentCount() const { return segments.size(); }

  /// [segmentCount] indices of four points: before, from, to, after (ends doubled).
  std::span<const glm::uvec4> all() const { return segments; }

  /// Sorts by the segments' middles along `viewDirection` (away from the camera), in steps of
  /// 1/65536 of the hair's depth; equal ones keep the strands' order.
  void sort(std::span<const glm::vec3> points, glm::vec3 viewDirection);

  /// Sorted. [segmentCount] pairs of points, or quadruples as in `all`.
  void writeLines(std::vector<glm::uvec2>& lines) const;
  void writeRibbons(std::vector<glm::uvec4>& ribbons) const;

 private:
  std::vector<std::uint32_t> topology;
  std::vector<glm::uvec4> segments;
  std::vector<float> depth;          // [pointCount]
  std::vector<std::uint16_t> keys;   // [segmentCount]
  std::vector<std::uint32_t> order;  // [segmentCount], the farthest first
  std::vector<std::uint32_t> counts;
};

}  // namespace hair::draw

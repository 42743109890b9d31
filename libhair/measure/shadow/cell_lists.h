#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace hair {

/// A uniform grid over segments: each cell lists the segments that come near it. Cells are cubes.
struct CellLists {
  glm::dvec3 lower{0};               ///< corner of cell (0, 0, 0), metres
  double cell = 1;                   ///< metres
  glm::ivec3 size{0};                ///< cells; 0: there is no segment
  std::vector<std::uint32_t> start;  ///< [cells + 1]
  std::vector<std::uint32_t> items;  ///< segments, cell by cell

  std::size_t index(glm::ivec3 c) const {
    return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(size.y) +
            static_cast<std::size_t>(c.y)) *
               static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(c.x);
  }
  std::span<const std::uint32_t> list(glm::ivec3 c) const {
    const std::size_t at = index(c);
    return std::span(items).subspan(start[at], start[at + 1] - start[at]);
  }
};

/// Segment i joins points[i] and points[i + 1]; it is listed by every cell that has a point within
/// `radius` of it. Cells are of about the size asked for, larger where there would be too many.
/// `axes`: 3, or 2 for a grid across a light: every z is then 0, and it is one cell thick.
CellLists makeCellLists(std::span<const glm::vec3> points, std::span<const std::uint32_t> segments,
                        double radius, double cell, int axes = 3);

}  // namespace hair

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hair {

/// Strands as chains of edges between numbered vertices, as programs for meshes keep them.
struct EdgeChains {
  std::vector<std::uint32_t> vertices;     ///< root to tip, strand after strand
  std::vector<std::uint32_t> first = {0};  ///< [strandCount + 1]
};

/// Follows edges to chains. A chain goes the way all its edges go; where they do not agree, from
/// its end of the lower number. Chains stand in the order of their roots' numbers. Vertices without
/// edges are strands of a point where `keepPoints`, for each vertex, says so; empty: all.
/// Throws Error that begins with `name` where a vertex has more than two edges, or where edges
/// close to a ring. Vertices of edges must be below vertexCount.
EdgeChains chainEdges(const std::vector<std::array<std::uint32_t, 2>>& edges,
                      std::size_t vertexCount, const std::vector<bool>& keepPoints,
                      std::string_view name);

}  // namespace hair

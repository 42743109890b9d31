#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hair {

/// Strands as chains of edges between numbered vertices, as in mesh programs.
struct EdgeChains {
  std::vector<std::uint32_t> vertices;     ///< root to tip, strand after strand
  std::vector<std::uint32_t> first = {0};  ///< [strandCount + 1]
};

/// Joins edges to chains. A chain has the direction of its edges; where these do not agree, it
/// starts at its end of the lower number. Chains are sorted by the numbers of their roots. A vertex
/// without edges is a strand of one point where `keepPoints`, for each vertex, says so; empty: all.
/// Throws Error that begins with `name` where a vertex has more than two edges, or where edges
/// form a ring. Vertices of edges must be below vertexCount.
EdgeChains chainEdges(const std::vector<std::array<std::uint32_t, 2>>& edges,
                      std::size_t vertexCount, const std::vector<bool>& keepPoints,
                      std::string_view name);

}  // namespace hair

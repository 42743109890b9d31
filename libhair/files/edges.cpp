#include <libhair/files/edges.h>

#include <algorithm>

#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// Neighbours of a vertex, and directions of its edges.
struct Vertex {
  std::array<std::uint32_t, 2> next = {kNone, kNone};
  std::uint8_t starting = 0;  // edges that start here

  std::uint32_t degree() const { return (next[0] != kNone) + (next[1] != kNone); }
};

}  // namespace

EdgeChains chainEdges(const std::vector<std::array<std::uint32_t, 2>>& edges,
                      std::size_t vertexCount, const std::vector<bool>& keepPoints,
                      std::string_view name) {
  std::vector<Vertex> graph(vertexCount);
  for (const auto& edge : edges) {
    for (int end = 0; end < 2; ++end) {
      Vertex& vertex = graph[edge[end]];
      require(vertex.degree() < 2, name, ": vertex ", edge[end],
              " (from 0) has more than two edges; strands have no branches");
      vertex.next[vertex.degree()] = edge[1 - end];
    }
    ++graph[edge[0]].starting;
  }

  EdgeChains chains;
  std::vector<bool> seen(vertexCount);
  std::vector<std::uint32_t> chain;
  std::vector<std::pair<std::size_t, std::size_t>> ranges;  // of `vertices`, before they are sorted
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t start = 0; start < vertexCount; ++start) {
    const bool point = graph[start].degree() == 0;
    if (seen[start] || graph[start].degree() == 2) continue;
    if (point && !keepPoints.empty() && !keepPoints[start]) continue;
    chain.clear();
    std::uint32_t before = kNone;
    // As every step leaves a vertex by another edge than it came, the walk ends.
    for (std::uint32_t at = start; at != kNone;) {
      chain.push_back(at);
      seen[at] = true;
      const auto [a, b] = graph[at].next;
      const std::uint32_t to = a == before ? b : a;
      before = at;
      at = to;
    }
    // All edges against the walk: each but the first vertex starts one.
    const bool backwards = graph[chain.front()].starting == 0 &&
                           std::all_of(chain.begin() + 1, chain.end(),
                                       [&](std::uint32_t v) { return graph[v].starting == 1; });
    if (backwards) std::reverse(chain.begin(), chain.end());
    ranges.emplace_back(vertices.size(), vertices.size() + chain.size());
    vertices.insert(vertices.end(), chain.begin(), chain.end());
  }
  for (std::size_t v = 0; v < vertexCount; ++v)
    require(seen[v] || graph[v].degree() == 0, name, ": vertex ", v,
            " (from 0) lies on a closed ring of edges; strands have a root and a tip");

  std::sort(ranges.begin(), ranges.end(),
            [&](const auto& a, const auto& b) { return vertices[a.first] < vertices[b.first]; });
  chains.vertices.reserve(vertices.size());
  for (const auto& [begin, end] : ranges) {
    chains.vertices.insert(chains.vertices.end(),
                           vertices.begin() + static_cast<std::ptrdiff_t>(begin),
                           vertices.begin() + static_cast<std::ptrdiff_t>(end));
    chains.first.push_back(static_cast<std::uint32_t>(chains.vertices.size()));
  }
  return chains;
}

}  // namespace hair

#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/surface.h>

#include <algorithm>
#include <tuple>

namespace hair {

namespace {

// The upper edge of a side quad: vertices of one layer, the smaller number first, and the corners
// of the quad. A vertex has one vertex below it, so quads with one upper edge are one quad.
struct UpperEdge {
  std::uint32_t low, high;
  std::uint32_t corner, next;

  bool operator<(const UpperEdge& other) const {
    return std::tie(low, high) < std::tie(other.low, other.high);
  }
  bool operator==(const UpperEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<UpperEdge> upperEdges(const HairMesh& mesh, std::size_t layer) {
  const std::vector<std::uint32_t>& corners = mesh.layers[layer].corners;
  std::vector<UpperEdge> edges;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] < layer) continue;
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      const std::uint32_t next = mesh.nextCorner(j, c);
      const auto [low, high] = std::minmax(corners[c], corners[next]);
      edges.push_back({low, high, c, next});
    }
  }
  std::stable_sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<PrismSide> prismSides(const HairMesh& mesh, std::size_t layer) {
  std::vector<PrismSide> quads;
  const std::vector<UpperEdge> edges = upperEdges(mesh, layer);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e > 0 && edges[e] == edges[e - 1]) continue;
    const bool shared = e + 1 < edges.size() && edges[e] == edges[e + 1];
    quads.push_back({edges[e].corner, edges[e].next, !shared});
  }
  return quads;
}

std::vector<std::vector<std::uint8_t>> exteriorVertices(const HairMesh& mesh) {
  std::vector<std::vector<std::uint8_t>> exterior;
  exterior.reserve(mesh.layerCount());
  for (const HairMesh::Layer& layer : mesh.layers) exterior.emplace_back(layer.vertexCount(), 0);

  if (!exterior.empty()) std::fill(exterior.front().begin(), exterior.front().end(), 1);
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (const std::uint32_t v : mesh.face(mesh.lastLayer[j], j))
      exterior[mesh.lastLayer[j]][v] = 1;

  for (std::size_t k = 1; k < mesh.layerCount(); ++k)
    for (const PrismSide& quad : prismSides(mesh, k)) {
      if (!quad.outer) continue;
      for (const std::uint32_t corner : {quad.corner, quad.next}) {
        exterior[k][mesh.layers[k].corners[corner]] = 1;
        exterior[k - 1][mesh.layers[k - 1].corners[corner]] = 1;
      }
    }
  return exterior;
}

}  // namespace hair

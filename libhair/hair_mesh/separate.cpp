#include <algorithm>
#include <utility>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

const LayerEdge& requireEdge(std::span<const LayerEdge> edges, std::size_t layer,
                             HairMeshEdge edge) {
  const LayerEdge* found = findEdge(edges, edge.a, edge.b);
  require(found != nullptr, "layer ", layer, ": no edge joins vertices ", edge.a, " and ", edge.b);
  return *found;
}

std::uint32_t cornerOf(const HairMesh::Layer& layer, std::uint32_t vertex) {
  return static_cast<std::uint32_t>(std::find(layer.corners.begin(), layer.corners.end(), vertex) -
                                    layer.corners.begin());
}

// Merges a and b, and the vertices below them, down to one that both stand on. Leaves unused
// vertices, which `rejoin` must remove.
void mergeDownward(std::size_t layer, std::uint32_t a, std::uint32_t b, HairMesh& mesh) {
  for (std::size_t k = layer; a != b; --k) {
    HairMesh::Layer& l = mesh.layers[k];
    const auto [kept, gone] = std::minmax(a, b);
    l.positions[kept] = 0.5f * (l.positions[a] + l.positions[b]);
    l.pinned[kept] = std::max(l.pinned[a], l.pinned[b]);
    std::replace(l.corners.begin(), l.corners.end(), gone, kept);
    const std::uint32_t belowA = l.below[a], belowB = l.below[b];
    a = belowA;
    b = belowB;
  }
}

// Welds corners of the layer with each other, pair by pair; `what` names them in the error.
void weldCorners(std::size_t layer,
                 std::span<const std::pair<std::uint32_t, std::uint32_t>> cornerPairs,
                 const std::string& what, HairMesh& mesh) {
  for (const auto& [a, b] : cornerPairs) {
    const std::vector<std::uint32_t>& corners = mesh.layers[layer].corners;
    mergeDownward(layer, corners[a], corners[b], mesh);
  }
  rejoinFrom(1, mesh);
  // rejoin has separated again those whose faces share no edge: they would be connected at a point.
  for (const auto& [a, b] : cornerPairs)
    require(mesh.layers[layer].corners[a] == mesh.layers[layer].corners[b], "layer ", layer, ": ",
            what, " would hold faces together at a point only; weld an edge that ends there");
}

}  // namespace

void separateEdges(std::size_t layer, std::span<const HairMeshEdge> cuts, HairMesh& mesh) {
  require(!cuts.empty(), "no edges are named");
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    const CornerTable table(m);
    std::vector<LayerEdge> edges = edgesOf(table, m.layers[layer].corners);
    std::vector<LayerEdge> cut;
    for (const HairMeshEdge& named : cuts) {
      cut.push_back(requireEdge(edges, layer, named));
      require(cut.back().isInner(), "layer ", layer, ": edge ", named.a, "-", named.b,
              " has a face on one side only, there is nothing to separate");
    }
    std::vector<std::uint8_t> isCut(m.cornerCount(), 0);
    for (const LayerEdge& c : cut) isCut[c.corner] = 1;
    std::erase_if(edges, [&](const LayerEdge& edge) { return isCut[edge.corner] != 0; });
    const auto fans = fansOf(table, edges, m.layers[layer].corners);
    for (const LayerEdge& c : cut)
      require(fans[c.corner] != fans[table.next[c.other]] ||
                  fans[c.other] != fans[table.next[c.corner]],
              "layer ", layer, ": edge ", c.a, "-", c.b,
              " would part nothing: at both its ends the faces on its sides stay joined around the "
              "vertex; cut on from one of them, or along two edges in a row");
    rejoin(layer, m, fans);
    rejoinFrom(layer + 1, m);
  });
}

void separateVertices(std::size_t layer, std::span<const std::uint32_t> vertices, HairMesh& mesh) {
  require(!vertices.empty(), "no vertices are named");
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    const std::vector<std::uint32_t>& corners = m.layers[layer].corners;
    std::vector<std::uint32_t> faces(m.layers[layer].vertexCount(), 0);
    for (const std::uint32_t v : corners)
      if (v != kNoVertex) ++faces[v];
    std::vector<std::uint8_t> named(faces.size(), 0);
    for (const std::uint32_t v : vertices) {
      requireVertex(m, layer, v);
      require(faces[v] > 1, "layer ", layer, ": vertex ", v,
              " has one face only, there is nothing to separate");
      named[v] = 1;
    }
    std::vector<std::uint32_t> parts(corners.size(), 0);
    for (std::uint32_t c = 0; c < corners.size(); ++c)
      if (corners[c] != kNoVertex && named[corners[c]]) parts[c] = c;
    rejoin(layer, m, parts);
    rejoinFrom(layer + 1, m);
  });
}

void weldVertices(std::size_t layer, std::uint32_t a, std::uint32_t b, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    requireVertex(m, layer, a);
    requireVertex(m, layer, b);
    require(a != b, "layer ", layer, ": vertex ", a, " is to be welded with itself");
    const std::uint32_t rootA = rootOf(m, layer, a), rootB = rootOf(m, layer, b);
    require(rootA == rootB, "layer ", layer, ": vertices ", a, " and ", b,
            " stand on different vertices of the scalp, ", rootA, " and ", rootB);
    const std::pair<std::uint32_t, std::uint32_t> pair = {cornerOf(m.layers[layer], a),
                                                          cornerOf(m.layers[layer], b)};
    weldCorners(layer, {&pair, 1}, text("vertices ", a, " and ", b), m);
  });
}

void weldEdges(std::size_t layer, HairMeshEdge a, HairMeshEdge b, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    const CornerTable table(m);
    const auto edges = edgesOf(table, m.layers[layer].corners);
    const LayerEdge &edgeA = requireEdge(edges, layer, a), &edgeB = requireEdge(edges, layer, b);
    const std::string what = text("edges ", a.a, "-", a.b, " and ", b.a, "-", b.b);
    require(&edgeA != &edgeB, "layer ", layer, ": edge ", a.a, "-", a.b,
            " is to be welded with itself");
    // Neighbouring faces traverse their edge in opposite directions.
    const std::vector<std::uint32_t>& root = m.layers[0].corners;
    const std::uint32_t startA = edgeA.corner, endA = table.next[startA];
    const std::uint32_t startB = edgeB.corner, endB = table.next[startB];
    require(root[startA] == root[endB] && root[endA] == root[startB], "layer ", layer, ": ", what,
            " do not stand on one edge of the scalp");
    const std::pair<std::uint32_t, std::uint32_t> pairs[] = {{startA, endB}, {endA, startB}};
    weldCorners(layer, pairs, what, m);
  });
}

}  // namespace hair

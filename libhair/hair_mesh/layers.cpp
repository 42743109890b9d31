#include <algorithm>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

// The faces of `bundles` in layer `from` become those in layer `to`, on vertices of their own.
void copyFaces(std::span<const std::uint32_t> bundles, const HairMesh::Layer& from,
               HairMesh::Layer& to, const HairMesh& mesh) {
  std::vector<std::uint32_t> copied(from.vertexCount(), kNoVertex);
  for (const std::uint32_t j : bundles)
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      const std::uint32_t v = from.corners[c];
      if (v != kNoVertex && copied[v] == kNoVertex) {
        copied[v] = static_cast<std::uint32_t>(to.positions.size());
        to.positions.push_back(from.positions[v]);
        to.pinned.push_back(from.pinned[v]);
      }
      to.corners[c] = v == kNoVertex ? kNoVertex : copied[v];
    }
}

// Of a valid mesh.
std::vector<std::uint32_t> connected(const HairMesh& mesh, std::size_t layer,
                                     std::uint32_t bundle) {
  requireBundle(mesh, bundle);
  require(layer <= mesh.lastLayer[bundle], "bundle ", bundle, " has no face in layer ", layer,
          ": its tip is in layer ", mesh.lastLayer[bundle]);
  const CornerTable table(mesh);
  JoinedSets sets(mesh.bundleCount());
  for (const LayerEdge& edge : edgesOf(table, mesh.layers[layer].corners))
    if (edge.isInner()) sets.join(table.bundle[edge.corner], table.bundle[edge.other]);
  std::vector<std::uint32_t> bundles;
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    if (sets.find(j) == sets.find(bundle)) bundles.push_back(j);
  return bundles;
}

}  // namespace

std::vector<std::uint32_t> connectedFaces(const HairMesh& mesh, std::size_t layer,
                                          std::uint32_t bundle) {
  validate(mesh);
  return connected(mesh, layer, bundle);
}

void insertLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    const std::vector<std::uint32_t> bundles = connected(m, layer, bundle);
    addEmptyLayer(m);
    for (std::size_t k = m.layerCount() - 1; k > layer; --k)
      copyFaces(bundles, m.layers[k - 1], m.layers[k], m);
    // No other face uses the vertices of these in `layer`: all connected faces have moved up.
    HairMesh::Layer& middle = m.layers[layer];
    std::vector<std::uint8_t> done(middle.vertexCount(), 0);
    for (const std::uint32_t j : bundles) {
      for (const std::uint32_t v : m.face(layer, j)) {
        if (done[v]) continue;
        done[v] = 1;
        middle.positions[v] =
            0.5f * (middle.positions[v] + m.layers[layer - 1].positions[middle.below[v]]);
        middle.pinned[v] = 0;
      }
      ++m.lastLayer[j];
    }
    rejoinFrom(layer, m);
  });
}

void removeLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireLayer(m, layer);
    const std::vector<std::uint32_t> bundles = connected(m, layer, bundle);
    addEmptyLayer(m);
    for (std::size_t k = layer; k + 1 < m.layerCount(); ++k)
      copyFaces(bundles, m.layers[k + 1], m.layers[k], m);
    for (const std::uint32_t j : bundles) --m.lastLayer[j];
    rejoinFrom(layer, m);
  });
}

}  // namespace hair

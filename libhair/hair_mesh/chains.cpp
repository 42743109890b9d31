#include <libhair/hair_mesh/chains.h>

#include <algorithm>

namespace hair {

HairMeshChains chainsOf(const HairMesh& mesh) {
  HairMeshChains chains;
  chains.chainOfCorner.assign(mesh.cornerCount(), kNoVertex);
  std::vector<std::vector<std::uint32_t>> chainAt;  // [layer][vertex]
  for (const HairMesh::Layer& layer : mesh.layers)
    chainAt.emplace_back(layer.vertexCount(), kNoVertex);

  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    const std::uint32_t tip = mesh.lastLayer[j];
    if (tip == 0) continue;
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      std::uint32_t vertex = mesh.layers[tip].corners[c];
      std::uint32_t& chain = chainAt[tip][vertex];
      if (chain == kNoVertex) {
        chain = static_cast<std::uint32_t>(chains.chainCount());
        for (std::uint32_t k = tip; k > 0; vertex = mesh.layers[k--].below[vertex])
          chains.vertices.push_back(vertex);
        chains.vertices.push_back(vertex);
        std::reverse(chains.vertices.begin() + chains.first.back(), chains.vertices.end());
        chains.first.push_back(static_cast<std::uint32_t>(chains.vertices.size()));
      }
      chains.chainOfCorner[c] = chain;
    }
  }
  return chains;
}

}  // namespace hair

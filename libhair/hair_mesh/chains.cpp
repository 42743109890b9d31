#include <libhair/hair_mesh/mesh_groom.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

HairMeshChains chainsOf(const HairMesh& mesh) {
  HairMeshChains chains;
  chains.chainOfCorner.assign(mesh.cornerCount(), kNoVertex);
  std::vector<std::vector<std::uint32_t>> chainAt;  // [layer][vertex]
  chainAt.reserve(mesh.layerCount());
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

void followGuides(const HairMesh& rest, const HairMeshChains& chains,
                  std::span<const glm::vec3> guidePoints, std::uint32_t pointsPerGuide,
                  HairMesh& moved) {
  require(pointsPerGuide >= 2 && guidePoints.size() == chains.chainCount() * pointsPerGuide,
          "followGuides: ", guidePoints.size(), " points for ", chains.chainCount(), " chains of ",
          pointsPerGuide);
  require(moved.layerCount() == rest.layerCount(), "followGuides: the moved mesh has ",
          moved.layerCount(), " layers instead of ", rest.layerCount());
  for (std::size_t k = 0; k < rest.layerCount(); ++k)
    require(moved.layers[k].vertexCount() == rest.layers[k].vertexCount(), "followGuides: layer ",
            k, " of the moved mesh has ", moved.layers[k].vertexCount(), " vertices instead of ",
            rest.layers[k].vertexCount());
  std::vector<std::vector<float>> shares;  // [layer][vertex], chains so far
  shares.reserve(rest.layerCount());
  for (std::size_t k = 0; k < rest.layerCount(); ++k) {
    shares.emplace_back(rest.layers[k].vertexCount(), 0.0f);
    std::fill(moved.layers[k].positions.begin(), moved.layers[k].positions.end(), glm::vec3(0));
  }
  const auto lengthTo = [&](std::span<const std::uint32_t> chain, std::size_t k) {
    float length = 0;
    for (std::size_t i = 0; i < k; ++i)
      length += glm::distance(rest.layers[i].positions[chain[i]],
                              rest.layers[i + 1].positions[chain[i + 1]]);
    return length;
  };
  for (std::size_t c = 0; c < chains.chainCount(); ++c) {
    const auto chain = chains.chain(c);
    const auto guide = guidePoints.subspan(c * pointsPerGuide, pointsPerGuide);
    const float whole = lengthTo(chain, chain.size() - 1);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const float share = whole > 0 ? lengthTo(chain, k) / whole : 0;
      const float at = share * static_cast<float>(pointsPerGuide - 1);
      const auto i = std::min(static_cast<std::uint32_t>(at), pointsPerGuide - 2);
      moved.layers[k].positions[chain[k]] +=
          glm::mix(guide[i], guide[i + 1], at - static_cast<float>(i));
      ++shares[k][chain[k]];
    }
  }
  for (std::size_t k = 0; k < rest.layerCount(); ++k)
    for (std::size_t v = 0; v < shares[k].size(); ++v) {
      // Scalp where no hair grows: of bundles without length.
      glm::vec3& p = moved.layers[k].positions[v];
      p = shares[k][v] > 0 ? p / shares[k][v] : rest.layers[k].positions[v];
    }
}

}  // namespace hair

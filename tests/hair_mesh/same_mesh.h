#pragma once

#include <map>
#include <tuple>

#include <libhair/hair_mesh/hair_mesh.h>

// Two ways for hair meshes to be the same.
namespace hair::test {

/// Every array, bit by bit.
inline bool identical(const HairMesh& a, const HairMesh& b) {
  if (a.firstCorner != b.firstCorner || a.lastLayer != b.lastLayer ||
      a.layerCount() != b.layerCount())
    return false;
  for (std::size_t k = 0; k < a.layerCount(); ++k) {
    const HairMesh::Layer &x = a.layers[k], &y = b.layers[k];
    if (x.positions != y.positions || x.below != y.below || x.corners != y.corners ||
        x.pinned != y.pinned)
      return false;
  }
  return true;
}

/// What is left of a mesh when vertices have no numbers: which corners are one vertex, and what
/// each has. Equal for meshes that differ in numbers of vertices alone.
struct Unnumbered {
  std::vector<std::uint32_t> firstCorner, lastLayer;
  std::vector<std::vector<std::uint32_t>> firstOf;  // [layer][corner], the vertex's first corner
  std::vector<std::vector<glm::vec3>> positions;    // [layer][corner]
  std::vector<std::vector<int>> pinned;             // [layer][corner], -1: no face

  explicit Unnumbered(const HairMesh& mesh)
      : firstCorner(mesh.firstCorner), lastLayer(mesh.lastLayer) {
    for (const HairMesh::Layer& layer : mesh.layers) {
      std::map<std::uint32_t, std::uint32_t> first;
      auto& firsts = firstOf.emplace_back();
      auto& places = positions.emplace_back();
      auto& pins = pinned.emplace_back();
      for (std::uint32_t c = 0; c < layer.corners.size(); ++c) {
        const std::uint32_t v = layer.corners[c];
        const bool isThere = v != kNoVertex;
        firsts.push_back(isThere ? first.try_emplace(v, c).first->second : kNoVertex);
        places.push_back(isThere ? layer.positions[v] : glm::vec3(0));
        pins.push_back(isThere ? layer.pinned[v] : -1);
      }
    }
  }
  bool operator==(const Unnumbered&) const = default;
};

}  // namespace hair::test

#include <libhair/hair_mesh/hair_mesh.h>

#include <libhair/core/error.h>

namespace hair {

std::size_t HairMesh::vertexCount() const {
  std::size_t count = 0;
  for (const Layer& layer : layers) count += layer.vertexCount();
  return count;
}

std::uint32_t rootOf(const HairMesh& mesh, std::size_t layer, std::uint32_t vertex) {
  for (std::size_t k = layer; k > 0; --k) vertex = mesh.layers[k].below[vertex];
  return vertex;
}

HairMesh makeHairMesh(const PolygonMesh& scalp) {
  HairMesh mesh;
  mesh.firstCorner = scalp.firstCorner;
  mesh.lastLayer.assign(scalp.faceCount(), 0);
  HairMesh::Layer& root = mesh.layers.emplace_back();
  std::vector<std::uint32_t> used(scalp.positions.size(), kNoVertex);
  for (const std::uint32_t v : scalp.corners) {
    require(v < used.size(), "scalp: a face names vertex ", v, " of ", used.size());
    if (used[v] == kNoVertex) {
      used[v] = static_cast<std::uint32_t>(root.positions.size());
      root.positions.push_back(scalp.positions[v]);
    }
    root.corners.push_back(used[v]);
  }
  root.pinned.assign(root.positions.size(), 0);
  validate(mesh, "scalp");
  return mesh;
}

void validate(const HairMesh& mesh, std::string_view name) {
  const std::string why = whyInvalid(mesh);
  require(why.empty(), name, ": ", why);
}

}  // namespace hair

#include <libhair/hair_mesh/surface.h>

#include <algorithm>

#include <libhair/hair_mesh/exterior.h>

namespace hair {

namespace {

// A fan around the middle; a middle does not favour a diagonal.
void addFlat(std::span<const glm::vec3> polygon, TriangleMesh& surface) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const auto n = static_cast<std::uint32_t>(polygon.size());
  glm::vec3 middle(0), normal(0);
  for (std::uint32_t i = 0; i < n; ++i) {
    middle += polygon[i] / static_cast<float>(n);
    normal += glm::cross(polygon[i] - polygon[0], polygon[(i + 1) % n] - polygon[0]);
  }
  const float length = glm::length(normal);
  normal = length > 0 ? normal / length : glm::vec3(0, 1, 0);
  surface.positions.insert(surface.positions.end(), polygon.begin(), polygon.end());
  surface.positions.push_back(middle);
  surface.normals.insert(surface.normals.end(), n + 1, normal);
  for (std::uint32_t i = 0; i < n; ++i)
    surface.triangles.emplace_back(first + i, first + (i + 1) % n, first + n);
}

}  // namespace

TriangleMesh outerSurface(const HairMesh& mesh) {
  TriangleMesh surface;
  const auto at = [&](std::size_t layer, std::uint32_t corner) {
    return mesh.layers[layer].positions[mesh.layers[layer].corners[corner]];
  };
  std::vector<glm::vec3> polygon;
  for (std::size_t k = 1; k < mesh.layerCount(); ++k)
    for (const PrismSide& q : prismSides(mesh, k)) {
      if (!q.outer) continue;
      polygon = {at(k - 1, q.corner), at(k - 1, q.next), at(k, q.next), at(k, q.corner)};
      addFlat(polygon, surface);
    }
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] == 0) continue;
    polygon.clear();
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c)
      polygon.push_back(at(mesh.lastLayer[j], c));
    addFlat(polygon, surface);
  }
  return surface;
}

std::vector<HairMeshLine> linesOf(const HairMesh& mesh) {
  std::vector<HairMeshLine> lines;
  for (std::uint32_t k = 0; k < mesh.layerCount(); ++k) {
    const std::vector<std::uint32_t>& corners = mesh.layers[k].corners;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
      if (mesh.lastLayer[j] >= k)
        for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c)
          edges.emplace_back(std::minmax(corners[c], corners[mesh.nextCorner(j, c)]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) lines.push_back({{k, a}, {k, b}});
    if (k > 0)
      for (std::uint32_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
        lines.push_back({{k - 1, mesh.layers[k].below[v]}, {k, v}});
  }
  return lines;
}

}  // namespace hair

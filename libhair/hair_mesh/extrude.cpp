#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

// Vertex normals from all faces of the layer, so that positions do not depend on the order in which
// faces are extruded. Zero where the faces have no area.
std::vector<glm::vec3> vertexNormals(const HairMesh& mesh, std::size_t k) {
  const HairMesh::Layer& layer = mesh.layers[k];
  std::vector<glm::dvec3> sums(layer.vertexCount(), glm::dvec3(0));
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] < k) continue;
    const auto face = mesh.face(k, j);
    const glm::dvec3 origin = layer.positions[face[0]];
    glm::dvec3 area(0);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      area += glm::cross(glm::dvec3(layer.positions[face[i]]) - origin,
                         glm::dvec3(layer.positions[face[i + 1]]) - origin);
    for (const std::uint32_t v : face) sums[v] += area;
  }
  std::vector<glm::vec3> normals(sums.size(), glm::vec3(0));
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (const double length = glm::length(sums[v]); length > 0) normals[v] = sums[v] / length;
  return normals;
}

// Corners on both sides of an edge, at both its ends: {start, the neighbour's end}, {end, its
// start}.
using EdgeEnds = std::array<std::array<std::uint32_t, 2>, 2>;

EdgeEnds endsOf(const LayerEdge& edge, const CornerTable& table,
                std::span<const std::uint32_t> vertices) {
  return {{{vertices[edge.corner], vertices[table.next[edge.other]]},
           {vertices[table.next[edge.corner]], vertices[edge.other]}}};
}

// Merges vertices of the layer above the tips. Existing ones keep their indices; those from
// `standing` on are new, one for each extruded corner.
class TipVertices {
 public:
  // `parted`: edges below whose two faces exist in the layer, but are not connected there.
  TipVertices(const HairMesh::Layer& layer, std::size_t standing, std::vector<EdgeEnds> parted)
      : layer_(layer),
        sets_(layer.vertexCount()),
        standing_(standing),
        parted_(std::move(parted)) {}

  // Joins both sides of an edge, unless that would need a vertex in two positions or close another
  // edge along which faces were separated.
  void tryToJoin(const EdgeEnds& ends) {
    bool stoodApart = false;
    for (const auto& [x, y] : ends) {
      const std::uint32_t a = sets_.find(x), b = sets_.find(y);
      if (a == b || a >= standing_ || b >= standing_) continue;
      if (layer_.positions[a] != layer_.positions[b] || layer_.pinned[a] != layer_.pinned[b])
        return;
      stoodApart = true;
    }
    if (stoodApart && closesAnother(ends)) return;
    for (const auto& [x, y] : ends) sets_.join(x, y);
  }
  std::uint32_t find(std::uint32_t x) { return sets_.find(x); }

 private:
  bool closesAnother(const EdgeEnds& ends) {
    const auto one = [&](const std::array<std::uint32_t, 2>& pair) {
      const auto named = [&](const auto& p) {
        return std::minmax({sets_.find(p[0]), sets_.find(p[1])});
      };
      const auto [a, b] = named(pair);
      return a == b || named(ends[0]) == std::pair(a, b) || named(ends[1]) == std::pair(a, b);
    };
    return std::any_of(parted_.begin(), parted_.end(),
                       [&](const EdgeEnds& edge) { return one(edge[0]) && one(edge[1]); });
  }

  const HairMesh::Layer& layer_;
  JoinedSets sets_;
  std::size_t standing_;
  std::vector<EdgeEnds> parted_;
};

// Extrudes the faces of layer k, all of them tips.
void extrudeLayer(std::size_t k, std::span<const std::uint32_t> bundles, float distance,
                  HairMesh& mesh) {
  if (k + 1 == mesh.layerCount()) addEmptyLayer(mesh);
  const HairMesh::Layer& tip = mesh.layers[k];
  HairMesh::Layer& next = mesh.layers[k + 1];
  const CornerTable table(mesh);

  // Inner edges of the tips' layer, and those of them already separated in the next layer.
  std::vector<LayerEdge> edges = edgesOf(table, tip.corners);
  std::erase_if(edges, [](const LayerEdge& edge) { return !edge.isInner(); });
  std::sort(edges.begin(), edges.end(),
            [](const LayerEdge& x, const LayerEdge& y) { return x.corner < y.corner; });
  const auto goesOn = [&](const LayerEdge& edge) {
    return next.corners[edge.corner] != kNoVertex && next.corners[edge.other] != kNoVertex;
  };
  std::vector<EdgeEnds> parted;
  for (const LayerEdge& edge : edges) {
    if (!goesOn(edge)) continue;
    const EdgeEnds ends = endsOf(edge, table, next.corners);
    if (ends[0][0] != ends[0][1] || ends[1][0] != ends[1][1]) parted.push_back(ends);
  }
  const std::size_t standing = next.vertexCount();

  const std::vector<glm::vec3> normals = vertexNormals(mesh, k);
  for (const std::uint32_t j : bundles) {
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      const std::uint32_t v = tip.corners[c];
      require(normals[v] != glm::vec3(0), "layer ", k, ", vertex ", v,
              ": the faces around it have no area, so there is no way to extrude bundle ", j,
              "; move its vertices apart");
      next.corners[c] = static_cast<std::uint32_t>(next.positions.size());
      next.positions.push_back(tip.positions[v] + distance * normals[v]);
      next.pinned.push_back(0);
    }
    ++mesh.lastLayer[j];
  }

  // Join new faces with each other first, then with existing ones, in the order of corners.
  TipVertices vertices(next, standing, std::move(parted));
  for (const int newFaces : {2, 1})
    for (const LayerEdge& edge : edges)
      if (goesOn(edge) &&
          (next.corners[edge.corner] >= standing) + (next.corners[edge.other] >= standing) ==
              newFaces)
        vertices.tryToJoin(endsOf(edge, table, next.corners));
  for (std::uint32_t& v : next.corners)
    if (v != kNoVertex) v = vertices.find(v);
  rejoinFrom(k + 1, mesh);
}

void eraseBundle(std::uint32_t j, HairMesh& mesh) {
  const std::uint32_t begin = mesh.firstCorner[j], end = mesh.firstCorner[j + 1];
  for (HairMesh::Layer& layer : mesh.layers)
    layer.corners.erase(layer.corners.begin() + begin, layer.corners.begin() + end);
  mesh.firstCorner.erase(mesh.firstCorner.begin() + j);
  for (std::size_t i = j; i < mesh.firstCorner.size(); ++i) mesh.firstCorner[i] -= end - begin;
  mesh.lastLayer.erase(mesh.lastLayer.begin() + j);
}

}  // namespace

void extrudeFaces(std::span<const std::uint32_t> bundles, float distance, HairMesh& mesh) {
  require(std::isfinite(distance), "the distance to extrude is not finite");
  editCopy(mesh, [&](HairMesh& m) {
    requireBundles(m, bundles);
    // Start at the top, so that each tip moves along its current normals.
    std::map<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> byLayer;
    for (const std::uint32_t j : bundles) byLayer[m.lastLayer[j]].push_back(j);
    for (auto& [layer, tips] : byLayer) {
      std::sort(tips.begin(), tips.end());
      extrudeLayer(layer, tips, distance, m);
    }
  });
}

void deleteFaces(std::span<const std::uint32_t> bundles, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireBundles(m, bundles);
    std::vector<std::uint32_t> sorted(bundles.begin(), bundles.end());
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    for (const std::uint32_t j : sorted) {
      if (m.lastLayer[j] == 0) {
        eraseBundle(j, m);
        continue;
      }
      HairMesh::Layer& tip = m.layers[m.lastLayer[j]--];
      std::fill(tip.corners.begin() + m.firstCorner[j], tip.corners.begin() + m.firstCorner[j + 1],
                kNoVertex);
    }
    require(m.bundleCount() > 0, "deleting every face would leave no scalp");
    rejoinFrom(0, m);
  });
}

}  // namespace hair

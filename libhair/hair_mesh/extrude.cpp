#include <algorithm>
#include <cmath>
#include <map>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

// Of all faces of the layer, so that a vertex goes to the same place whichever of them are extruded
// first. Zero where they have no area.
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

// Which vertices of the layer above the tips become one. They are numbered as there; those from
// `standing` on are new, one for each corner extruded.
class TipVertices {
 public:
  // standingFans: [standing], equal where faces hang together below, edge by edge.
  TipVertices(const HairMesh::Layer& layer, std::vector<std::uint32_t> standingFans)
      : layer_(layer), sets_(layer.vertexCount()), standing_(standingFans.size()) {
    for (const std::uint32_t fan : standingFans) fans_.push_back({fan});
  }

  void join(std::uint32_t x, std::uint32_t y) {
    x = sets_.find(x);
    y = sets_.find(y);
    if (x == y) return;
    sets_.join(x, y);
    if (std::max(x, y) < standing_)
      fans_[std::min(x, y)].insert(fans_[std::min(x, y)].end(), fans_[std::max(x, y)].begin(),
                                   fans_[std::max(x, y)].end());
  }

  // Two that stood apart join where they coincide, unless they were separated: then faces beside
  // each other below stand on both.
  bool mayJoin(std::uint32_t x, std::uint32_t y) {
    x = sets_.find(x);
    y = sets_.find(y);
    if (x == y || x >= standing_ || y >= standing_) return true;
    const bool separated = std::find_first_of(fans_[x].begin(), fans_[x].end(), fans_[y].begin(),
                                              fans_[y].end()) != fans_[x].end();
    return !separated && layer_.positions[x] == layer_.positions[y] &&
           layer_.pinned[x] == layer_.pinned[y];
  }

  std::uint32_t find(std::uint32_t x) { return sets_.find(x); }

 private:
  const HairMesh::Layer& layer_;
  JoinedSets sets_;
  std::size_t standing_;
  std::vector<std::vector<std::uint32_t>> fans_;  // of a set, by its name
};

// Extrudes the faces of layer k, all of them tips.
void extrudeLayer(std::size_t k, std::span<const std::uint32_t> bundles, float distance,
                  HairMesh& mesh) {
  if (k + 1 == mesh.layerCount()) addEmptyLayer(mesh);
  const HairMesh::Layer& tip = mesh.layers[k];
  HairMesh::Layer& next = mesh.layers[k + 1];
  const CornerTable table(mesh);

  // Faces that stand in the next layer already, and how they hang together in this one.
  std::vector<std::uint32_t> beside(tip.corners);
  for (std::size_t c = 0; c < beside.size(); ++c)
    if (next.corners[c] == kNoVertex) beside[c] = kNoVertex;
  const auto fans = fansOf(table, edgesOf(table, beside), beside);
  const std::size_t standing = next.vertexCount();
  std::vector<std::uint32_t> standingFans(standing);
  for (std::size_t c = 0; c < fans.size(); ++c)
    if (fans[c] != kNoVertex) standingFans[next.corners[c]] = fans[c];

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

  // New faces join among themselves first, then those that stood there, in the order of corners.
  TipVertices vertices(next, std::move(standingFans));
  std::vector<LayerEdge> edges = edgesOf(table, tip.corners);
  std::erase_if(edges, [&](const LayerEdge& edge) {
    return !edge.isInner() || next.corners[edge.corner] == kNoVertex ||
           next.corners[edge.other] == kNoVertex;
  });
  std::sort(edges.begin(), edges.end(),
            [](const LayerEdge& x, const LayerEdge& y) { return x.corner < y.corner; });
  for (const int newOnes : {2, 1})
    for (const LayerEdge& edge : edges) {
      const std::uint32_t a = next.corners[edge.corner], b = next.corners[table.next[edge.corner]];
      const std::uint32_t c = next.corners[edge.other], d = next.corners[table.next[edge.other]];
      if ((a >= standing) + (c >= standing) != newOnes) continue;
      if (!vertices.mayJoin(a, d) || !vertices.mayJoin(b, c)) continue;
      vertices.join(a, d);
      vertices.join(b, c);
    }
  for (std::uint32_t& v : next.corners)
    if (v != kNoVertex) v = vertices.find(v);
  rejoinFrom(k + 1, mesh);
}

template <class Entry>
void eraseCorners(std::vector<Entry>& array, std::uint32_t begin, std::uint32_t end) {
  array.erase(array.begin() + begin, array.begin() + end);
}

void eraseBundle(std::uint32_t j, HairMesh& mesh) {
  const std::uint32_t begin = mesh.firstCorner[j], end = mesh.firstCorner[j + 1];
  for (HairMesh::Layer& layer : mesh.layers) eraseCorners(layer.corners, begin, end);
  mesh.firstCorner.erase(mesh.firstCorner.begin() + j);
  for (std::size_t i = j; i < mesh.firstCorner.size(); ++i) mesh.firstCorner[i] -= end - begin;
  mesh.lastLayer.erase(mesh.lastLayer.begin() + j);
}

}  // namespace

void extrudeFaces(std::span<const std::uint32_t> bundles, float distance, HairMesh& mesh) {
  require(std::isfinite(distance), "the distance to extrude is not finite");
  editCopy(mesh, [&](HairMesh& m) {
    requireBundles(m, bundles);
    // From the top, so that each tip goes along the normals it has now.
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

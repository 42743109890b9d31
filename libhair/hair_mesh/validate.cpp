#include <algorithm>
#include <cmath>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/geometry/openmesh-inl.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {

namespace {

// Each check returns its first violation, or nothing; a check relies on the checks before it.

std::string wrongBundleArrays(const HairMesh& mesh) {
  const std::size_t bundles = mesh.bundleCount();
  if (mesh.layers.empty()) return "no layers: there is no scalp";
  if (mesh.firstCorner.size() != bundles + 1)
    return text("firstCorner has ", mesh.firstCorner.size(), " entries, needs ", bundles + 1,
                ": one more than lastLayer");
  if (mesh.firstCorner[0] != 0) return text("firstCorner begins with ", mesh.firstCorner[0]);
  for (std::size_t j = 0; j < bundles; ++j) {
    const std::uint32_t begin = mesh.firstCorner[j], end = mesh.firstCorner[j + 1];
    if (end < begin || end - begin < 3)
      return text("bundle ", j, ": corners ", begin, " to ", end, ", needs at least 3 sides");
  }
  return {};
}

std::string wrongArrays(const HairMesh& mesh, std::size_t k) {
  const HairMesh::Layer& layer = mesh.layers[k];
  const std::size_t vertices = layer.vertexCount();
  const std::size_t below = k == 0 ? 0 : mesh.layers[k - 1].vertexCount();
  const auto wrongSize = [&](const char* array, std::size_t size, std::size_t needs) {
    return text("layer ", k, ": ", array, " has ", size, " entries, needs ", needs);
  };
  if (layer.corners.size() != mesh.cornerCount())
    return wrongSize("corners", layer.corners.size(), mesh.cornerCount());
  if (layer.pinned.size() != vertices) return wrongSize("pinned", layer.pinned.size(), vertices);
  if (layer.below.size() != (k == 0 ? 0 : vertices))
    return wrongSize("below", layer.below.size(), k == 0 ? 0 : vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const glm::vec3& p = layer.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return text("layer ", k, ", vertex ", v, ": its position is not finite");
    if (layer.pinned[v] > 1)
      return text("layer ", k, ", vertex ", v, ": pinned is ", int{layer.pinned[v]},
                  ", not 0 or 1");
    if (k > 0 && layer.below[v] >= below)
      return text("layer ", k, ", vertex ", v, ": stands on vertex ", layer.below[v], " of ",
                  below);
  }
  return {};
}

std::string wrongCorners(const HairMesh& mesh, std::size_t k) {
  const std::size_t vertices = mesh.layers[k].vertexCount();
  std::vector<std::size_t> lastIn(vertices, mesh.bundleCount());  // of each vertex, the bundle
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    const auto face = mesh.face(k, j);
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] == kNoVertex) continue;
      if (face[i] >= vertices)
        return text("layer ", k, ", face of bundle ", j, ": corner ", i, " is vertex ", face[i],
                    " of ", vertices);
      if (std::exchange(lastIn[face[i]], j) == j)
        return text("layer ", k, ", face of bundle ", j, ": vertex ", face[i], " is in it twice");
    }
  }
  return {};
}

std::string wrongFaces(const HairMesh& mesh) {
  const std::size_t top = mesh.layerCount() - 1;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] > top)
      return text("bundle ", j, ": lastLayer is ", mesh.lastLayer[j], " of ", mesh.layerCount(),
                  " layers");
    bool ended = false;
    for (std::size_t k = 0; k <= top; ++k) {
      const auto face = mesh.face(k, j);
      const auto missing = std::count(face.begin(), face.end(), kNoVertex);
      if (missing != 0 && missing != static_cast<std::ptrdiff_t>(face.size()))
        return text("layer ", k, ", face of bundle ", j, ": ", missing, " of its ", face.size(),
                    " corners have no vertex");
      if (missing == 0 && ended)
        return text("layer ", k, ", face of bundle ", j, ": stands on no face of the layer below");
      ended = missing != 0;
      if ((k <= mesh.lastLayer[j]) == ended)
        return text("layer ", k, ", face of bundle ", j, ended ? ": is missing" : ": is there",
                    ", and lastLayer says that the tip is in layer ", mesh.lastLayer[j]);
    }
  }
  if (std::find(mesh.lastLayer.begin(), mesh.lastLayer.end(), top) == mesh.lastLayer.end())
    return text("layer ", top, ": the top layer has no face");
  return {};
}

std::string wrongVertices(const HairMesh& mesh, std::size_t k) {
  const HairMesh::Layer& layer = mesh.layers[k];
  std::vector<std::uint8_t> used(layer.vertexCount(), 0);
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      const std::uint32_t v = layer.corners[c];
      if (v == kNoVertex) continue;
      used[v] = 1;
      if (k > 0 && layer.below[v] != mesh.layers[k - 1].corners[c])
        return text("layer ", k, ", vertex ", v, ": its corner in the face of bundle ", j,
                    " stands on vertex ", mesh.layers[k - 1].corners[c], ", below says ",
                    layer.below[v], " (one-to-many: a vertex stands on one vertex)");
    }
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused == used.end()) return {};
  return text("layer ", k, ", vertex ", unused - used.begin(), ": no face uses it");
}

// Why `surface` with this face would not be a manifold; empty if it would be one.
std::string whyRefused(const OpenPolyMesh& surface,
                       const std::vector<OpenPolyMesh::VertexHandle>& face) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto a = face[i], b = face[(i + 1) % face.size()];
    const auto edge = surface.find_halfedge(a, b);
    if (!edge.is_valid() || edge.is_boundary()) continue;
    return edge.opp().is_boundary()
               ? text("a neighbour runs along edge ", a.idx(), "-", b.idx(),
                      " the same way (faces are oriented alike)")
               : text("edge ", a.idx(), "-", b.idx(), " has two faces already (two-manifold)");
  }
  for (const auto v : face)
    if (!surface.is_boundary(v))
      return text("vertex ", v.idx(), " is closed around already (two-manifold)");
  return "it would close around a vertex while other faces hang there (two-manifold)";
}

std::string notManifold(const HairMesh& mesh, std::size_t k) {
  OpenPolyMesh surface;
  for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v) surface.add_vertex({});
  std::vector<OpenPolyMesh::VertexHandle> handles;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] < k) continue;
    handles.clear();
    for (const std::uint32_t v : mesh.face(k, j)) handles.emplace_back(static_cast<int>(v));
    if (!surface.add_face(handles).is_valid())
      return text("layer ", k, ", face of bundle ", j, ": ", whyRefused(surface, handles));
  }
  for (const auto v : surface.vertices())
    if (!surface.is_manifold(v))
      return text("layer ", k, ", vertex ", v.idx(),
                  ": faces around it are not joined edge to edge");
  return {};
}

}  // namespace

std::string whyInvalid(const HairMesh& mesh) {
  std::string why = wrongBundleArrays(mesh);
  const auto eachLayer = [&](auto check) {
    for (std::size_t k = 0; why.empty() && k < mesh.layerCount(); ++k) why = check(mesh, k);
  };
  eachLayer(wrongArrays);
  eachLayer(wrongCorners);
  if (why.empty()) why = wrongFaces(mesh);
  eachLayer(wrongVertices);
  const SilentOpenMesh silent;
  eachLayer(notManifold);
  return why;
}

}  // namespace hair

#pragma once

#include <span>
#include <utility>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/hair_mesh.h>

// Shared by the operations. Each changes corners of some layers without regard to vertices;
// `rejoin` then rebuilds the vertices: two corners share a vertex if they did before, stand on the
// same vertex below, and their faces are connected edge to edge. So splits propagate upward, and no
// vertex joins faces only at a point.
namespace hair {

/// Runs `edit` on a copy: `mesh` changes when the copy is valid, or not at all.
template <class Edit>
void editCopy(HairMesh& mesh, Edit&& edit) {
  validate(mesh, "hair mesh before the operation");
  HairMesh copy = mesh;
  edit(copy);
  validate(copy, "hair mesh after the operation");
  mesh = std::move(copy);
}

/// An edge of a layer.
struct LayerEdge {
  std::uint32_t a = 0, b = 0;       ///< vertices, a < b
  std::uint32_t corner = 0;         ///< that starts it in the first of its faces
  std::uint32_t other = kNoVertex;  ///< that starts it in the second; kNoVertex: there is none

  bool isInner() const { return other != kNoVertex; }
};

/// [cornerCount]: the bundle of each corner, and the next corner around its face.
struct CornerTable {
  std::vector<std::uint32_t> bundle, next;

  explicit CornerTable(const HairMesh& mesh);
};

/// Edges of the layer whose corners have these vertices (or any labels), ordered by a, b.
std::vector<LayerEdge> edgesOf(const CornerTable& table, std::span<const std::uint32_t> vertices);

/// The edge between two vertices, nullptr if there is none.
const LayerEdge* findEdge(std::span<const LayerEdge> edges, std::uint32_t a, std::uint32_t b);

/// Disjoint sets (union-find); each is represented by its least member.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t size);
  std::uint32_t find(std::uint32_t x);
  void join(std::uint32_t x, std::uint32_t y);

 private:
  std::vector<std::uint32_t> parent_;
};

/// For each corner the least corner of its fan: those of the same vertex in faces that are
/// connected around it edge to edge, across `edges`. kNoVertex where there is no face.
std::vector<std::uint32_t> fansOf(const CornerTable& table, std::span<const LayerEdge> edges,
                                  std::span<const std::uint32_t> vertices);

/// Makes the vertices of a layer from its corners, and `below` from the layer below. Corners of one
/// vertex keep sharing it if `parts` (empty, or [cornerCount]) has one value for them, they stand
/// on one vertex and are one fan. The fan with the least corner keeps the vertex's number, the
/// others' vertices are appended; vertices that no corner uses are removed, and higher numbers move
/// down.
void rejoin(std::size_t layer, HairMesh& mesh, std::span<const std::uint32_t> parts = {});

/// rejoin for `layer` and all above; then drops empty layers at the top.
void rejoinFrom(std::size_t layer, HairMesh& mesh);

/// Adds a layer without faces at the top.
void addEmptyLayer(HairMesh& mesh);

// Validation of arguments.
void requireBundle(const HairMesh& mesh, std::uint32_t bundle);
void requireBundles(const HairMesh& mesh, std::span<const std::uint32_t> bundles);
void requireLayer(const HairMesh& mesh, std::size_t layer);
void requireVertex(const HairMesh& mesh, std::size_t layer, std::uint32_t vertex);

}  // namespace hair

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Marks a corner without a vertex: its bundle ends in a lower layer.
inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// Polygons of any number of sides, counter-clockwise seen from outside.
struct PolygonMesh {
  std::vector<glm::vec3> positions;              ///< [vertexCount], metres
  std::vector<std::uint32_t> firstCorner = {0};  ///< [faceCount + 1], never decreasing
  std::vector<std::uint32_t> corners;            ///< [cornerCount], vertex of each corner

  /// Number of polygons.
  std::size_t faceCount() const { return firstCorner.size() - 1; }
  /// Vertices of polygon f.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(firstCorner[f], firstCorner[f + 1] - firstCorner[f]);
  }
};

/// The volume that hair fills, as layers of polygons on a scalp (Yuksel, Schaefer, Keyser 2009,
/// "Hair Meshes", section 3.1).
///
///   layer 2 (tip of j = 1)        +-----+          F_1^2
///                                 |  1  |
///   layer 1 (tip of j = 0)  +-----+-----+          F_0^1  F_1^1
///                           |  0  |  1  |
///   layer 0, the scalp      +-----+-----+          F_0^0  F_1^0
///
/// Bundle j is the stack of faces F_j^0 ... F_j^{n_j}, all of as many sides; hair of it starts in
/// F_j^0 and ends in F_j^{n_j}. Corner i of F_j^k goes on as corner i of F_j^{k+1}: a corner is a
/// chain through the layers, and all layers share one numbering of corners, [cornerCount]. A vertex
/// has one vertex below it and may have several above: bundles that share a vertex in one layer may
/// be separate in the next, and never join again.
///
/// Every vertex is a corner of a face; `validate` checks all these constraints. Space: head space,
/// metres, as Groom. Value type: copy it to undo an edit.
struct HairMesh {
  /// One layer: its vertices, and the faces that they make.
  struct Layer {
    std::vector<glm::vec3> positions;    ///< [vertexCount of this layer], metres
    std::vector<std::uint32_t> below;    ///< [vertexCount], vertex of the layer below; root: empty
    std::vector<std::uint32_t> corners;  ///< [cornerCount], vertex or kNoVertex
    std::vector<std::uint8_t> pinned;    ///< [vertexCount], 1: stays where the user put it

    /// Vertices of this layer.
    std::size_t vertexCount() const { return positions.size(); }
  };

  std::vector<std::uint32_t> firstCorner = {0};  ///< [bundleCount + 1]
  std::vector<std::uint32_t> lastLayer;          ///< [bundleCount], n_j: the tip's layer
  std::vector<Layer> layers;  ///< [layerCount], root first; the last is not empty

  /// Number of bundles, one for each face of the scalp.
  std::size_t bundleCount() const { return lastLayer.size(); }
  /// Number of corners of one layer's faces, those above a tip included.
  std::size_t cornerCount() const { return firstCorner.back(); }
  /// Number of layers, the scalp's included.
  std::size_t layerCount() const { return layers.size(); }
  std::size_t vertexCount() const;  ///< of all layers
  /// Number of sides of each of the bundle's faces.
  std::uint32_t sides(std::size_t bundle) const {
    return firstCorner[bundle + 1] - firstCorner[bundle];
  }
  /// Vertices of F_bundle^layer; kNoVertex, all of them, above the bundle's tip.
  std::span<const std::uint32_t> face(std::size_t layer, std::size_t bundle) const {
    return std::span(layers[layer].corners).subspan(firstCorner[bundle], sides(bundle));
  }
  /// The corner after this one around its face.
  std::uint32_t nextCorner(std::size_t bundle, std::uint32_t corner) const {
    return corner + 1 == firstCorner[bundle + 1] ? firstCorner[bundle] : corner + 1;
  }
};

/// One vertex of one layer.
struct HairMeshVertex {
  std::uint32_t layer = 0,  ///< 0: the scalp
      vertex = 0;           ///< in that layer
  /// The same vertex of the same layer.
  bool operator==(const HairMeshVertex&) const = default;
};

/// The vertex of the scalp that a vertex of `layer` stands on.
std::uint32_t rootOf(const HairMesh& mesh, std::size_t layer, std::uint32_t vertex);

/// The root layer alone: every face of the scalp is a bundle without length (n_j = 0). Vertices
/// that no face uses are left out. Throws Error if the result is not valid (validate).
HairMesh makeHairMesh(const PolygonMesh& scalp);

/// First violation of the constraints of section 3.1, in one sentence ("layer 2, face of bundle
/// 7: ..."); empty for a valid mesh. Checked in this order:
/// - arrays: sizes, offsets, indices, at least 3 sides, no vertex twice in a face, finite
/// positions;
/// - faces: each on one of the layer below, tip layers as lastLayer says, the top layer not empty;
/// - vertices: corners of one vertex stand on one vertex of the layer below (one-to-many, upward),
///   which is `below`; each is used by a face;
/// - layers: two-manifold, faces oriented alike, the faces around a vertex joined edge to edge.
std::string whyInvalid(const HairMesh& mesh);

/// Throws Error with `name` and whyInvalid's sentence, unless the mesh is valid.
void validate(const HairMesh& mesh, std::string_view name = "hair mesh");

}  // namespace hair

#pragma once

#include <array>

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>

// Topological operations (Yuksel et al. 2009, section 3.2). Each turns a valid mesh into a valid
// mesh, or throws Error with the reason and changes nothing. New vertices get positions; call
// placeInterior afterwards to optimise interior ones. Layers above the scalp only: the root layer
// is the scalp's, and only smooth subdivision moves its vertices.
//
// Vertices keep their indices where possible: of a vertex that splits, the first of its fans of
// faces keeps the index and others are appended to the layer; indices behind removed vertices move
// down. Faces connected only at a point are separated too.
namespace HAIR_API hair {

/// An edge of one layer, by its two vertices in either order.
struct HairMeshEdge {
  std::uint32_t a = 0,  ///< vertex of the layer
      b = 0;            ///< vertex of the layer
};

/// Face Extrude: a new tip for each bundle, `distance` metres along the normals of the layer that
/// its tip is in (of all faces there, by area; so the order in which neighbours are extruded does
/// not matter). A new face is joined with each neighbour across an edge of that layer that has a
/// face in the next one: first new ones with each other, then, by number of corner, with existing
/// ones, which stay in place. Where that would need a vertex at two positions, the faces stay
/// separate along the edge; where two separate vertices coincide, pins included, they become one,
/// unless that would close an edge along which faces were separated.
void extrudeFaces(std::span<const std::uint32_t> bundles, float distance, HairMesh& mesh);

/// Face Delete: removes the tip face of each bundle; of a bundle without length the scalp's face:
/// no hair grows there any more, and the numbers of later bundles decrease by one.
void deleteFaces(std::span<const std::uint32_t> bundles, HairMesh& mesh);

/// Bundles whose faces in `layer` are connected edge to edge to that of `bundle`; ascending. Throws
/// Error if `bundle` has none there.
std::vector<std::uint32_t> connectedFaces(const HairMesh& mesh, std::size_t layer,
                                          std::uint32_t bundle);

/// Layer Insert: a layer half-way between `layer` (1 or above) and the one below it, for all
/// bundles connected to `bundle` in that layer; the old `layer` becomes layer + 1. The new one has
/// the same separations.
void insertLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh);

/// Layer Remove: the faces of `layer` (1 or above) of all bundles connected to `bundle` there. At
/// tips the same as Face Delete.
void removeLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh);

/// Edge Separate: cuts along edges of `layer` (1 or above). Each of their vertices is replaced by
/// one for every fan of faces that the cuts leave around it, all at the same position; likewise in
/// the layers above. Throws Error for a single inner edge, which would separate at neither end.
void separateEdges(std::size_t layer, std::span<const HairMeshEdge> edges, HairMesh& mesh);

/// Vertex Separate: each face around the vertex gets a vertex of its own; likewise in the layers
/// above.
void separateVertices(std::size_t layer, std::span<const std::uint32_t> vertices, HairMesh& mesh);

/// Vertex Weld: joins vertices of one layer that stand on the same vertex of the scalp, half-way
/// between them; likewise those below them. Layers above stay separate. The result is pinned if one
/// of them was. Throws Error where their faces would share no edge, but be connected at a point.
void weldVertices(std::size_t layer, std::uint32_t a, std::uint32_t b, HairMesh& mesh);

/// Edge Weld: welds the ends of two edges; ends that are one vertex already stay.
void weldEdges(std::size_t layer, HairMeshEdge a, HairMeshEdge b, HairMesh& mesh);

/// Face Divide: splits bundle j between two of its corners (numbered 0 to sides - 1, not
/// neighbours), in all of its layers. The part from cornerA to cornerB stays bundle j, the other
/// becomes the last bundle. Returns its number.
std::uint32_t divideFace(std::uint32_t bundle, std::uint32_t cornerA, std::uint32_t cornerB,
                         HairMesh& mesh);

/// Edge Divide: a new corner half-way along the edge that starts at `corner` (0 to sides - 1), in
/// all layers of the bundle and of its neighbour across that edge of the scalp.
void divideEdge(std::uint32_t bundle, std::uint32_t corner, HairMesh& mesh);

/// Rule of subdivision.
enum class Subdivision : std::uint8_t {
  CatmullClark,  ///< each face of n sides into n of four; Catmull and Clark 1978
  Loop,          ///< each triangle into four; Loop 1987. Refused unless all faces are triangles
};

/// Subdivides every layer, the scalp's too, each by the rule applied to it alone, boundaries as
/// cubic B-splines. `smooth` false: the same topology, old vertices stay and new ones are in the
/// middle of edges and faces. Old vertices keep their pins (smoothing moves them all the same).
/// Bundle j's parts are bundles first[j] ... of the new mesh: one at each of its corners, in their
/// order, then with Loop the one in the middle. Returns first, [old bundleCount + 1].
std::vector<std::uint32_t> subdivide(Subdivision rule, bool smooth, HairMesh& mesh);

}  // namespace hair

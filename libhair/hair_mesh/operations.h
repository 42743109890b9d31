#pragma once

#include <array>

#include <libhair/hair_mesh/hair_mesh.h>

// Topological operations (Yuksel et al. 2009, section 3.2). Each leaves a valid mesh, or throws
// Error with the reason and changes nothing. New vertices get places; who wants interior ones where
// the surface wants them calls placeInterior afterwards. Layers above the scalp only: the root
// layer is the scalp's.
namespace hair {

/// Between two neighbouring corners of one layer, in either order.
struct HairMeshEdge {
  std::uint32_t a = 0, b = 0;
};

/// Face Extrude: a new tip for each bundle, `distance` metres along the vertex normals of the tips
/// extruded. Faces that share an edge in their tip layer and are at the same layer stay joined
/// along it, to those extruded before as well.
void extrudeFaces(std::span<const std::uint32_t> bundles, float distance, HairMesh& mesh);

/// Face Delete: removes the tip face of each bundle; of a bundle without length the scalp's face
/// too: hair no longer grows there, and the numbers of bundles behind it go down by one.
void deleteFaces(std::span<const std::uint32_t> bundles, HairMesh& mesh);

/// Bundles whose faces in `layer` are joined, edge by edge, to that of `bundle`; ascending.
std::vector<std::uint32_t> connectedFaces(const HairMesh& mesh, std::size_t layer,
                                          std::uint32_t bundle);

/// Layer Insert: a layer half-way between `layer` (1 or above) and the one below it, for all
/// bundles connected to `bundle` in that layer; what was `layer` is then layer + 1.
void insertLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh);

/// Layer Remove: the faces of `layer` (1 or above) of all bundles connected to `bundle` there. At
/// tips the same as Face Delete.
void removeLayer(std::size_t layer, std::uint32_t bundle, HairMesh& mesh);

/// Edge Separate: cuts along edges of `layer` (1 or above). Each of their vertices becomes one for
/// every fan of faces that the cuts leave around it, all at the same place; and above likewise.
/// Refused where that parts nothing: a single edge inside.
void separateEdges(std::size_t layer, std::span<const HairMeshEdge> edges, HairMesh& mesh);

/// Vertex Separate: each face around the vertex gets a vertex of its own; and above likewise.
void separateVertices(std::size_t layer, std::span<const std::uint32_t> vertices, HairMesh& mesh);

/// Vertex Weld: joins vertices of one layer that stand on the same vertex of the scalp, half-way
/// between them; and those below them likewise.
void weldVertices(std::size_t layer, std::uint32_t a, std::uint32_t b, HairMesh& mesh);

/// Edge Weld: both ends of two edges; ends that are one vertex already stay.
void weldEdges(std::size_t layer, HairMeshEdge a, HairMeshEdge b, HairMesh& mesh);

/// Face Divide: bundle j is cut in two between two of its corners (numbered 0 to sides - 1, not
/// neighbours), in all of its layers. The part from cornerA to cornerB stays bundle j, the other is
/// the last bundle. Returns its number.
std::uint32_t divideFace(std::uint32_t bundle, std::uint32_t cornerA, std::uint32_t cornerB,
                         HairMesh& mesh);

/// Edge Divide: a new corner half-way along the edge that starts at `corner` (0 to sides - 1), in
/// all layers of the bundle and of its neighbour across that edge of the scalp.
void divideEdge(std::uint32_t bundle, std::uint32_t corner, HairMesh& mesh);

enum class Subdivision : std::uint8_t {
  CatmullClark,  ///< each face of n sides into n of four; Catmull and Clark 1978
  Loop,          ///< each triangle into four; Loop 1987. Refused unless all faces are triangles
};

/// Subdivides every layer, each by the rule applied to it alone (boundaries by the rule for
/// boundaries). `smooth` false: the same topology, new vertices in the middle of edges and faces.
/// Bundle j's parts are, in order of its corners, bundles first[j] ... of the new mesh; returns
/// first, [old bundleCount + 1].
std::vector<std::uint32_t> subdivide(Subdivision rule, bool smooth, HairMesh& mesh);

}  // namespace hair

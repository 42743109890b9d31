#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/geometry/triangle_mesh.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace HAIR_API hair {

/// [layer][vertex], 1 for exterior vertices: those of the scalp, of tip faces, and of side quads
/// that a single bundle has (Yuksel et al. 2009, section 3.3, figure 2a); 0 for interior ones,
/// which are never visible. `mesh` is valid (validate).
std::vector<std::vector<std::uint8_t>> exteriorVertices(const HairMesh& mesh);

/// The outer surface of the volume, as it is modelled (Yuksel et al. 2009, section 3.3): tip faces
/// and the side quads that a single bundle has; the scalp is left open. Every face has vertices and
/// a normal of its own, so that it is drawn flat. Faces between more than three corners are fans
/// around their middle. `mesh` is valid.
TriangleMesh outerSurface(const HairMesh& mesh);

/// Edges of faces, and from layer to layer, each once.
struct HairMeshLine {
  HairMeshVertex a,  ///< one end
      b;             ///< the other
};
/// All of them, layer by layer.
std::vector<HairMeshLine> linesOf(const HairMesh& mesh);

}  // namespace hair

// What the view is without hair meshes (HAIR_WITH_HAIR_MESH=OFF): there is none to show.
#include <apps/common/mesh_overlay.h>

namespace hair {

struct MeshOverlay::State {};

MeshOverlay::MeshOverlay(const HairMesh&) {}
MeshOverlay::~MeshOverlay() = default;
void MeshOverlay::follow(const Hair&) {}
void MeshOverlay::place(const HairMesh&, const RigidTransform&) {}
void MeshOverlay::drawLines(bool, draw::DebugLayer&) const {}
TriangleMesh MeshOverlay::surface() const {
  return {};
}

}  // namespace hair

#pragma once

#include <memory>

#include <apps/common/mesh_hair.h>
#include <apps/draw/scene.h>
#include <libhair/geometry/triangle_mesh.h>
#include <libhair/simulation/frame.h>

namespace hair {

/// Shows the hair mesh under a player's hair, in the colours of the paper (Yuksel et al. 2009,
/// figure 2): scalp green, tips purple, exterior vertices blue, interior ones red.
class MeshOverlay {
 public:
  explicit MeshOverlay(const HairMesh& mesh);
  ~MeshOverlay();

  /// The mesh where the hair's guides have taken it, world space.
  void follow(const Hair& hair);
  /// The mesh as it stands, on a head.
  void place(const HairMesh& mesh, const RigidTransform& worldFromHead);

  /// Lines and dots; of the interior too where `inside` says so.
  void drawLines(bool inside, draw::DebugLayer& layer) const;
  TriangleMesh surface() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hair

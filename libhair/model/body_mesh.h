#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/transform.h>
#include <libhair/core/triangle_mesh.h>
#include <libhair/motion/body.h>

namespace hair {

/// A tailor's dummy around a skeleton, to be drawn: trunk with neck, arms, legs as closed surfaces
/// that overlap; no head. Skinned by blending the motion of up to four joints a vertex.
class BodyMesh {
 public:
  /// `cell`: edge of the grid that the surface is cut from, metres; triangles go as 1 / cell².
  explicit BodyMesh(const Body& body, float cell = 0.014f);

  /// The surface in a pose, worldFromJoint [jointCount]. No allocation where `out` comes from an
  /// earlier call; triangles are written only where their number differs.
  void skin(std::span<const RigidTransform> worldFromJoint, TriangleMesh& out) const;

  /// In body space, rest stance.
  const TriangleMesh& rest() const { return rest_; }

 private:
  TriangleMesh rest_;
  std::vector<RigidTransform> jointFromBody_;  ///< [jointCount], rest stance
  std::vector<glm::u16vec4> joints_;           ///< [vertexCount]
  std::vector<glm::vec4> weights_;             ///< [vertexCount], sum 1
};

}  // namespace hair

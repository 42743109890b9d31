#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/triangle_mesh.h>

namespace HAIR_API hair {

struct Body;

/// A tailor's dummy around a skeleton, to be drawn: trunk with neck, arms, legs as closed surfaces
/// that overlap; no head. Skinned linearly by up to four joints a vertex. A skeleton that is not
/// understood (BodyMap::complete) gets its capsules, joint by joint.
class BodyMesh {
 public:
  /// `cell`: edge of the grid that the surface is cut from, metres; triangles go as 1 / cell². Of a
  /// body far larger than a person the grid is coarser, so that it has as many cells at most.
  explicit BodyMesh(const Body& body, float cell = 0.014f);

  /// The surface in a pose, worldFromJoint [jointCount]. No allocation where `out` comes from an
  /// earlier call; triangles are written only where their number differs.
  void skin(std::span<const RigidTransform> worldFromJoint, TriangleMesh& out) const;

  /// In body space, rest stance.
  const TriangleMesh& rest() const { return rest_; }

 private:
  /// Four joints of a vertex, as indices into carriers_, and how much each counts: sum 1.
  struct Binding {
    std::uint8_t carrier[4];
    float weight[4];
  };
  struct Carrier {
    int joint;
    RigidTransform jointFromBody;  ///< rest stance
  };
  static constexpr std::size_t kMaxCarriers = 64;

  struct Weights;
  void add(const TriangleMesh& part, const Body& body, const std::vector<Weights>& weights);

  TriangleMesh rest_;
  std::vector<Binding> bindings_;  ///< [vertexCount]
  std::vector<Carrier> carriers_;
};

}  // namespace hair

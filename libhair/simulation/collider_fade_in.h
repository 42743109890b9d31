#pragma once

#include <vector>

#include <libhair/simulation/frame.h>

namespace hair {

/// Introduces colliders gradually: capsules grow from radius 0, meshes from 1 % of their size about
/// their centres, planes rise from below the lowest guide point. The solver then moves hair out of
/// them smoothly instead of ejecting it.
class ColliderFadeIn {
 public:
  /// Copies the colliders: `body` may refer to the arrays of a Hair.
  ColliderFadeIn(const BodyState& body, const GuideStrands& guides);
  /// The colliders at `share`: 0 absent, 1 full size. Valid until the next call.
  BodyState at(float share);

 private:
  struct Colliders {
    std::vector<Capsule> capsules;
    std::vector<Plane> planes;
    std::vector<MeshCollider> meshes;
  };
  RigidTransform worldFromHead_;
  Colliders full_, now_;
  std::vector<float> below_;  // metres from each plane down to the lowest guide point
};

}  // namespace hair

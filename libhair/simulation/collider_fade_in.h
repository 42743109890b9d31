#pragma once

#include <vector>

#include <libhair/simulation/frame.h>

namespace hair {

/// Colliders that come to hair where they were none: capsules grow from nothing, meshes from next
/// to nothing about their middles, planes rise from below the lowest guide point. Hair finds its
/// way out of them instead of being thrown out.
class ColliderFadeIn {
 public:
  /// Copies what it needs: the body may be the one that a hair remembers.
  ColliderFadeIn(const BodyState& body, const GuideStrands& guides);
  /// 0: nothing there, 1: all of it. Holds until the next call.
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

#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include <libhair/simulation/frame.h>

namespace hair {

/// A saved state that has been read and belongs to a hair, but is not in it yet: the caller may
/// look at it, and refuse it, while the hair is unchanged. Arrays as in Hair, of the same sizes.
struct SavedState {
  RigidTransform worldFromHead;
  std::vector<Capsule> capsules;
  std::vector<Plane> planes;
  std::vector<MeshCollider>
      meshes;  // with the hair's distance fields; empty if their number differs
  double time = 0;
  // Hair::guides
  RigidTransform worldFromRoots;
  std::vector<LaneVec3> position, velocity;
  std::vector<Lanes> tension;
  // Hair::repulsion
  std::vector<Lanes> allowed, windShare;
  std::vector<LaneVec3> push;
  std::uint32_t learntWith = 0, turn = 0;
  float waiting = 0;
  // Hair::wisps
  std::vector<glm::vec3> points, rootOffsets;
  std::vector<float> clearance;
};

/// Reads a state of this hair. Throws Error as restoreState does.
SavedState readState(std::istream& in, const Hair& hair);
/// Replaces the hair's state by one that was read for it.
void assignState(SavedState&& state, Hair& hair) noexcept;

}  // namespace hair

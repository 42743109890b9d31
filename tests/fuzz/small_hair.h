#pragma once

#include <string>
#include <vector>

#include <libhair/simulation/frame.h>

namespace hair {

/// As little hair as has all that a saved state can hold: two guides of three points, three drawn
/// strands, a head in motion, a capsule, a plane and a mesh, self-collision and wind that hair
/// occludes.
struct SmallHair {
  /// `full`: else without colliders, self-collision and wind.
  explicit SmallHair(bool full = true);
  SmallHair(const SmallHair&) = delete;

  void step();
  /// What saveState writes.
  std::string state() const;

  FrameSettings settings;
  Groom groom;
  MeshSdf block;  ///< of a cube
  std::vector<Plane> planes;
  std::vector<MeshCollider> meshes;
  std::vector<Capsule> capsules;
  Hair hair;
  FrameProfile profile{};
  int frames = 0;
};

/// A state with the check sum that its bytes, damaged or not, ask for.
std::string withCheckSum(std::string state);

/// With everything, and with as little as can be; early and late.
std::vector<std::string> sampleStates();

}  // namespace hair

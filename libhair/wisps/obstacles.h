#pragma once

#include <cstdint>
#include <vector>

#include <libhair/guides/contact.h>
#include <libhair/wisps/guide_curves.h>

namespace hair {

/// Head and body as drawn strands meet them, and how much room the guides have among them: most
/// points stay so near to their main guide that they cannot reach anything, and need no look.
struct WispObstacles {
  struct Axis {
    glm::vec3 a, axis;    ///< of a capsule: its points are a + t · axis, t in [0, 1]
    float perLength2;     ///< 1 / |axis|², 0 for a sphere
    float keep;           ///< how far drawn points keep from the axis, metres
    glm::vec3 low, high;  ///< box of everything within kReach of that, metres
  };

  /// Guides look no farther than this for capsules, metres.
  static constexpr float kReach = 0.05f;

  const MeshSdf* head = nullptr;
  glm::mat3 worldFromHead{1};  ///< rotation
  glm::vec3 translation{0};
  std::vector<Axis> axes;           ///< [capsules], at most 64
  std::vector<std::uint64_t> near;  ///< [guideCount], bit c: capsule c is within kReach
  /// [guideCount · 2 · samples] and kLanes more: for each guide how far from its samples there is
  /// nothing of the head, then of the body, metres squared; 0 where there may be something.
  std::vector<float> room;

  bool none() const { return !head && axes.empty(); }
  const float* roomOf(std::size_t guide, std::size_t samples) const {
    return room.data() + guide * 2 * samples;
  }
};

/// Takes the colliders as they stand, and measures around the curves. Drawn points keep `clearance`
/// metres, of the head never more. Threads over guides. Throws Error for more than 64 capsules.
void findObstacles(const ColliderState& colliders, float clearance, const GuideCurves& curves,
                   WispObstacles& obstacles);

}  // namespace hair

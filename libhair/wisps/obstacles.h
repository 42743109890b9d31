#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/guides/contact.h>
#include <libhair/wisps/guide_curves.h>

namespace HAIR_API hair {

/// Head and body as drawn strands meet them, and how much room the guides have among them: most
/// points stay so near to their main guide that they cannot reach anything, and need no look.
struct WispObstacles {
  struct Axis {
    glm::vec3 a, axis;    ///< of a capsule: its points are a + t · axis, t in [0, 1]
    float perLength2;     ///< 1 / |axis|², 0 for a sphere
    float keep;           ///< how far drawn points keep from the axis, metres
    glm::vec3 low, high;  ///< box of everything within kReach of that, metres
  };

  struct Face {
    glm::vec3 normal;
    float offset;  ///< of a plane: drawn points keep dot(normal, p) at or above it
  };
  struct Mesh {
    const MeshSdf* sdf;
    glm::mat3 worldFromMesh;  ///< rotation
    glm::vec3 translation;
    float scale, keep;  ///< keep: how far drawn points stay off, metres
  };

  /// Guides look no farther than this for anything but the head, metres.
  static constexpr float kReach = 0.05f;

  const MeshSdf* head = nullptr;
  glm::mat3 worldFromHead{1};  ///< rotation
  glm::vec3 translation{0};
  std::vector<Axis> axes;   ///< [capsules], at most 64
  std::vector<Face> faces;  ///< [planes]
  std::vector<Mesh> meshes;
  std::vector<std::uint64_t> near;  ///< [guideCount], bit c: capsule c is within kReach
  /// [guideCount · 2 · samples] and kLanes more: for each guide how far from its samples there is
  /// nothing of the head, then of anything else, metres squared; 0 where there may be something.
  std::vector<float> room;

  bool onlyHead() const { return axes.empty() && faces.empty() && meshes.empty(); }
  bool none() const { return !head && onlyHead(); }
  const float* roomOf(std::size_t guide, std::size_t samples) const {
    return room.data() + guide * 2 * samples;
  }
};

/// Takes the colliders as they stand, and measures around the curves. Drawn points keep `clearance`
/// metres, of the head never more. Threads over guides. Throws Error for more than 64 capsules, and
/// for scenery that is not valid.
void findObstacles(const ColliderState& colliders, float clearance, const GuideCurves& curves,
                   WispObstacles& obstacles);

}  // namespace hair

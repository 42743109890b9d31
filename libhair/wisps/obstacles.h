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
  /// A capsule.
  struct Axis {
    glm::vec3 a,       ///< of a capsule: its points are a + t · axis, t in [0, 1]
        axis;          ///< from one end to the other, metres
    float perLength2;  ///< 1 / |axis|², 0 for a sphere
    float keep;        ///< how far drawn points keep from the axis, metres
    glm::vec3 low,     ///< box of everything within kReach of that, metres
        high;          ///< its other corner
  };

  /// A plane.
  struct Face {
    glm::vec3 normal;  ///< unit, to the free side
    float offset;      ///< of a plane: drawn points keep dot(normal, p) at or above it
  };
  /// A mesh by its distance field.
  struct Mesh {
    const MeshSdf* sdf;       ///< not owned
    glm::mat3 worldFromMesh;  ///< rotation
    glm::vec3 translation;    ///< metres
    float scale,              ///< metres of the world in one of the mesh
        keep;                 ///< how far drawn points stay off, metres
  };

  /// Guides look no farther than this for anything but the head, metres.
  static constexpr float kReach = 0.05f;

  const MeshSdf* head = nullptr;    ///< in head space; null: none
  glm::mat3 worldFromHead{1};       ///< rotation
  glm::vec3 translation{0};         ///< of the head, metres
  std::vector<Axis> axes;           ///< [capsules], at most 64
  std::vector<Face> faces;          ///< [planes]
  std::vector<Mesh> meshes;         ///< [meshes] of the scenery
  std::vector<std::uint64_t> near;  ///< [guideCount], bit c: capsule c is within kReach
  /// [guideCount · 2 · samples] and kLanes more: for each guide how far from its samples there is
  /// nothing of the head, then of anything else, metres squared; 0 where there may be something.
  std::vector<float> room;

  /// No body and no scenery.
  bool onlyHead() const { return axes.empty() && faces.empty() && meshes.empty(); }
  /// Nothing at all to collide with.
  bool none() const { return !head && onlyHead(); }
  /// `room` of a guide: for the head, then for the rest, `samples` each.
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

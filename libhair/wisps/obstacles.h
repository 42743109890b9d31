#pragma once

#include <cstdint>
#include <vector>

#include <libhair/guides/contact.h>
#include <libhair/wisps/guide_curves.h>

namespace hair {

/// Colliders of the drawn strands, and the distance from the guides to them ("room"): most points
/// are nearer to their main guide than that, and need no collision test.
struct WispObstacles {
  /// A capsule.
  struct Axis {
    glm::vec3 a,       ///< one end: points of the axis are a + t · axis, t in [0, 1]
        axis;          ///< from one end to the other, metres
    float perLength2;  ///< 1 / |axis|², 0 for a sphere
    float keep;        ///< distance that drawn points keep from the axis, metres
    glm::vec3 low,     ///< lower corner of the box of all points within keep + kReach, metres
        high;          ///< upper corner
  };

  /// A plane.
  struct Face {
    glm::vec3 normal;  ///< unit, to the free side
    float offset;      ///< drawn points keep dot(normal, p) >= offset, metres
  };
  /// A mesh by its distance field.
  struct Mesh {
    const MeshSdf* sdf;       ///< not owned
    glm::mat3 worldFromMesh;  ///< rotation
    glm::vec3 translation;    ///< metres
    float scale,              ///< of the mesh, as MeshCollider has it
        keep;                 ///< distance that drawn points keep, metres
  };

  /// Largest room that is measured to anything but the head, metres.
  static constexpr float kReach = 0.05f;

  const MeshSdf* head = nullptr;    ///< in head space; null: none
  glm::mat3 worldFromHead{1};       ///< rotation
  glm::vec3 translation{0};         ///< of the head, metres
  std::vector<Axis> axes;           ///< [capsules], at most 64
  std::vector<Face> faces;          ///< [planes]
  std::vector<Mesh> meshes;         ///< [meshes] of the scenery
  std::vector<std::uint64_t> near;  ///< [guideCount], bit c: capsule c is within kReach
  /// [guideCount · 2 · samples], padded by kLanes: for each guide, the squared radius around each
  /// sample, metres², that is free of the head, and then that free of all else; 0 where none is
  /// known.
  std::vector<float> room;

  /// No body and no scenery.
  bool onlyHead() const { return axes.empty() && faces.empty() && meshes.empty(); }
  /// No obstacles.
  bool none() const { return !head && onlyHead(); }
  /// `room` of a guide: for the head, then for the rest, `samples` each.
  const float* roomOf(std::size_t guide, std::size_t samples) const {
    return room.data() + guide * 2 * samples;
  }
};

/// Copies the colliders, and measures the room of the guide curves among them. Drawn points keep
/// `clearance` metres, from the head at most that. Threads over guides. Throws Error for more than
/// 64 capsules, and for invalid scenery.
void findObstacles(const ColliderState& colliders, float clearance, const GuideCurves& curves,
                   WispObstacles& obstacles);

}  // namespace hair

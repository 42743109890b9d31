#pragma once

#include <memory>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/triangle_mesh.h>

namespace HAIR_API hair {

/// Signed distance to a triangle mesh on a regular grid: negative inside.
///
/// Accepts any mesh. Vertices at one position are merged; every hole is closed by a fan to its
/// middle (so the bottom of a bust gets a lid). A node is inside if the winding numbers along at
/// least two of the three grid lines through it say so, so that small defects of a mesh stay local.
/// Distances are exact at nodes within two cells of the surface, and between nodes within about 5 %
/// of a cell where the surface is smooth; far away within about a cell.
class MeshSdf {
 public:
  /// `cell` and `margin` (how far the grid reaches beyond the mesh) in metres, > 0. The defaults
  /// are for a head. Throws Error for an empty mesh, one that is not finite or has triangles
  /// without vertices, or if the grid would have more than 2^27 nodes.
  explicit MeshSdf(const TriangleMesh& mesh, float cell = 4e-3f, float margin = 0.03f);

  /// Metres. Outside the grid: a lower bound of the distance, never less than `margin`.
  float distance(glm::vec3 p) const;

  /// A lower bound of `distance`, from one node instead of eight: clears most points. A whole cell
  /// is subtracted, more than half its diagonal, which allows for the grid's own error too.
  float lowerBound(glm::vec3 p) const {
    const glm::vec3 inBox = glm::clamp(p, box_.lower, box_.upper);
    if (inBox != p) return margin_;
    const glm::ivec3 i((p - box_.lower) * perCell_ + 0.5f);
    const std::size_t at = (static_cast<std::size_t>(i.z) * static_cast<std::size_t>(nodes_.y) +
                            static_cast<std::size_t>(i.y)) *
                               static_cast<std::size_t>(nodes_.x) +
                           static_cast<std::size_t>(i.x);
    return distances_[at] - cell_;
  }

  /// xyz = unit outward direction, w = distance as above. Costs four times as much.
  glm::vec4 distanceAndGradient(glm::vec3 p) const;

  /// The box of the grid, metres.
  const Bounds& box() const { return box_; }

  /// Its arrays, for kernels that look up many points at once (mesh_sdf-inl.h).
  struct Field {
    Bounds box;                  ///< of the grid, metres
    float cell,                  ///< of the grid, metres
        perCell,                 ///< 1 / cell
        margin;                  ///< metres around the mesh
    const float* distances;      ///< [nodes.x · nodes.y · nodes.z], x fastest, metres
    const glm::vec3* gradients;  ///< the same shape, metres a metre
  };
  /// The arrays; valid while this exists.
  Field field() const {
    return {box_, cell_, perCell_, margin_, distances_.data(), gradients_.data()};
  }
  /// Number of nodes along each axis.
  glm::ivec3 nodes() const { return nodes_; }

 private:
  Bounds box_;
  float cell_, perCell_, margin_;
  glm::ivec3 nodes_;  ///< along each axis
  // [nodes_.x · nodes_.y · nodes_.z], x fastest. Stored apart, as most look-ups read distances
  // only.
  std::vector<float> distances_;
  std::vector<glm::vec3> gradients_;  ///< central differences
};

/// MeshSdf(mesh, cell, margin), shared between all callers with equal positions, triangles, cell
/// and margin (compared by value). A field takes seconds to build and tens of megabytes; it is
/// freed with its last owner. Thread-safe: two threads that ask for a new field at once may both
/// build it, but get the same one. Throws Error as MeshSdf does.
std::shared_ptr<const MeshSdf> sharedSdf(const TriangleMesh& mesh, float cell = 4e-3f,
                                         float margin = 0.03f);

}  // namespace hair

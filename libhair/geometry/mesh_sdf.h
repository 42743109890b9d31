#pragma once

#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/triangle_mesh.h>

namespace HAIR_API hair {

/// Signed distance to a triangle mesh on a regular grid: negative inside.
///
/// Any mesh will do. Vertices at one position are taken as one; every hole is closed by a fan to
/// its middle (so the bottom of a bust is a lid); inside is where at least two of the three grid
/// lines through a node wind around it, so small faults of a mesh do not spread. Distances are
/// exact at nodes within two cells of the surface, and between nodes within about 5 % of a cell
/// where the surface is smooth; far away within about a cell.
class MeshSdf {
 public:
  /// `cell` and `margin` (how far the grid reaches beyond the mesh) in metres, > 0. The defaults
  /// are for a head. Throws Error for an empty mesh, one that is not finite or has triangles
  /// without vertices, or if the grid would have more than 2^27 nodes.
  explicit MeshSdf(const TriangleMesh& mesh, float cell = 4e-3f, float margin = 0.03f);

  /// Metres. Outside the grid: a lower bound of the distance, never less than `margin`.
  float distance(glm::vec3 p) const;

  /// Not more than `distance`, from one node instead of eight: enough to know that most points are
  /// clear. A cell is more than half its diagonal, so it allows for the grid's own error too.
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

  /// What the grid covers, metres.
  const Bounds& box() const { return box_; }

  /// Its arrays, for kernels that look up many points at once (mesh_sdf-inl.h).
  struct Field {
    Bounds box;                  ///< what the grid covers, metres
    float cell,                  ///< of the grid, metres
        perCell,                 ///< 1 / cell
        margin;                  ///< metres around the mesh
    const float* distances;      ///< [nodes.x · nodes.y · nodes.z], x fastest, metres
    const glm::vec3* gradients;  ///< the same shape, metres a metre
  };
  /// Valid as long as this is.
  Field field() const {
    return {box_, cell_, perCell_, margin_, distances_.data(), gradients_.data()};
  }
  /// Of the grid, an axis.
  glm::ivec3 nodes() const { return nodes_; }

 private:
  Bounds box_;
  float cell_, perCell_, margin_;
  glm::ivec3 nodes_;  ///< an axis
  // [nodes_.x · nodes_.y · nodes_.z], x fastest. Apart, as most look-ups end with the distance.
  std::vector<float> distances_;
  std::vector<glm::vec3> gradients_;  ///< central differences
};

}  // namespace hair

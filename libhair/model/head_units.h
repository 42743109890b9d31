#pragma once

#include <span>

#include <libhair/files/strand_file.h>
#include <libhair/geometry/triangle_mesh.h>

namespace hair {

/// Roots this near to a head's surface, metres, lie on it.
inline constexpr float kRootsOnHead = 0.02f;

/// Median distance of some of the roots (metres, +Y up, +Z face) to a mesh whose file has these
/// units and axes, metres.
float rootDistance(const TriangleMesh& mesh, std::span<const glm::vec3> roots,
                   const ReadOptions& units);

/// Of the units and axes that files use, those that bring the mesh nearest to the roots, and their
/// rootDistance.
struct UnitsThatFit {
  ReadOptions units;
  float distance;
};
UnitsThatFit unitsThatFit(const TriangleMesh& mesh, std::span<const glm::vec3> roots);

/// Every so many-th root, at most `most` of them.
std::vector<glm::vec3> someOf(std::span<const glm::vec3> roots, std::size_t most);

}  // namespace hair

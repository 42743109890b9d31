#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <libhair/geometry/triangle_mesh.h>

namespace hair {

/// Index of the first vertex at the same position, for every vertex.
std::vector<std::uint32_t> weldVertices(std::span<const glm::vec3> positions);

/// The parts of a mesh: triangles that are connected through vertices, where vertices at one
/// position count as one (programs divide them along seams of a texture).
struct MeshParts {
  std::vector<std::uint32_t> of;  ///< [triangleCount]
  std::uint32_t count = 0;
};
MeshParts partsOf(const TriangleMesh& mesh);

/// Removes the vertices that no triangle has; returns how many.
std::size_t dropUnusedVertices(TriangleMesh& mesh);

}  // namespace hair

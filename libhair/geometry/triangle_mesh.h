#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Triangles by index, counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<glm::vec3> positions;   ///< [vertexCount], metres
  std::vector<glm::vec3> normals;     ///< [vertexCount], unit; smooth
  std::vector<glm::uvec3> triangles;  ///< [triangleCount]
};

/// Area-weighted smooth normals from positions and triangles; (0, 1, 0) where a vertex has none.
void computeNormals(TriangleMesh& mesh);

}  // namespace hair

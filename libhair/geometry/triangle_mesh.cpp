#include <libhair/geometry/triangle_mesh.h>

namespace hair {

void computeNormals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (glm::uvec3 t : mesh.triangles) {
    const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    const glm::vec3 n = glm::cross(b - a, c - a);  // twice the area long
    for (int k = 0; k < 3; ++k) mesh.normals[t[k]] += n;
  }
  for (glm::vec3& n : mesh.normals) {
    const float length = glm::length(n);
    n = length > 0 ? n / length : glm::vec3(0, 1, 0);
  }
}

}  // namespace hair

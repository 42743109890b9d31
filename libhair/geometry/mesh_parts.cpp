#include <libhair/geometry/mesh_parts.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hair {

std::vector<std::uint32_t> weldVertices(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> order(positions.size()), same(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::tuple(positions[i].x, positions[i].y, positions[i].z, i);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && positions[order[k]] == positions[order[k - 1]];
    same[order[k]] = repeated ? same[order[k - 1]] : order[k];
  }
  return same;
}

MeshParts partsOf(const TriangleMesh& mesh) {
  // Union-find over the vertices, each joined to the first of its triangle.
  std::vector<std::uint32_t> parent = weldVertices(mesh.positions);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 1; k < 3; ++k) parent[root(t[k])] = root(t[0]);
  MeshParts parts;
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
  for (const glm::uvec3& t : mesh.triangles) {
    std::uint32_t& part = number[root(t[0])];
    if (part == kNone) part = parts.count++;
    parts.of.push_back(part);
  }
  return parts;
}

std::size_t dropUnusedVertices(TriangleMesh& mesh) {
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> place(mesh.positions.size(), kNone);
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) place[t[k]] = 0;
  std::uint32_t kept = 0;
  const bool normals = mesh.normals.size() == mesh.positions.size();
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kNone) continue;
    mesh.positions[kept] = mesh.positions[v];
    if (normals) mesh.normals[kept] = mesh.normals[v];
    place[v] = kept++;
  }
  const std::size_t dropped = mesh.positions.size() - kept;
  mesh.positions.resize(kept);
  if (normals) mesh.normals.resize(kept);
  for (glm::uvec3& t : mesh.triangles) t = {place[t.x], place[t.y], place[t.z]};
  return dropped;
}

}  // namespace hair

#pragma once

#include <glm/glm.hpp>

#include <array>
#include <initializer_list>
#include <map>

#include <tests/hair_mesh/sample_meshes.h>

// Scalps of other shapes than the grid.
namespace hair::test {

inline void addFace(PolygonMesh& scalp, std::initializer_list<std::uint32_t> face) {
  scalp.corners.insert(scalp.corners.end(), face);
  scalp.firstCorner.push_back(static_cast<std::uint32_t>(scalp.corners.size()));
}

/// A ball of 6 n^2 quads, closed: a cube blown up.
inline PolygonMesh ballScalp(int n, float radius = 0.1f) {
  PolygonMesh scalp;
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](glm::ivec3 cell) {
    const auto number = static_cast<std::uint32_t>(scalp.positions.size());
    const auto [at, isNew] = vertices.try_emplace({cell.x, cell.y, cell.z}, number);
    if (isNew)
      scalp.positions.push_back(radius * glm::normalize(2.f * glm::vec3(cell) / float(n) - 1.f));
    return at->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            glm::ivec3 cell(0);
            cell[axis] = side;
            cell[(axis + 1) % 3] = u;
            cell[(axis + 2) % 3] = v;
            return vertex(cell);
          };
          if (side == 0)
            addFace(scalp,
                    {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
          else
            addFace(scalp,
                    {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
  return scalp;
}

/// The grid with every square cut in two.
inline PolygonMesh triangleScalp(std::uint32_t columns, std::uint32_t rows) {
  const PolygonMesh grid = gridScalp(columns, rows);
  PolygonMesh scalp;
  scalp.positions = grid.positions;
  for (std::size_t f = 0; f < grid.faceCount(); ++f) {
    const auto q = grid.face(f);
    addFace(scalp, {q[0], q[1], q[2]});
    addFace(scalp, {q[0], q[2], q[3]});
  }
  return scalp;
}

/// A hexagon, a triangle or a square on each of its sides in turn, and pentagons between those.
inline PolygonMesh mixedScalp() {
  PolygonMesh scalp;
  const auto add = [&](float radius, float degrees) {
    const float angle = glm::radians(degrees);
    scalp.positions.emplace_back(radius * std::cos(angle), 0.01f * std::cos(2 * angle),
                                 -radius * std::sin(angle));
    return static_cast<std::uint32_t>(scalp.positions.size() - 1);
  };
  std::uint32_t inner[6], left[6], right[6], far[6];
  for (int i = 0; i < 6; ++i) inner[i] = add(0.02f, 60.f * float(i));
  for (int i = 0; i < 6; ++i) {
    right[i] = add(0.04f, 60.f * float(i) + 20);
    left[i] = i % 2 == 0 ? right[i] : add(0.04f, 60.f * float(i) + 40);
    far[i] = add(0.05f, 60.f * float(i));
  }
  addFace(scalp, {inner[0], inner[1], inner[2], inner[3], inner[4], inner[5]});
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    if (i % 2 == 0)
      addFace(scalp, {inner[i], right[i], inner[next]});
    else
      addFace(scalp, {inner[i], right[i], left[i], inner[next]});
    addFace(scalp, {inner[next], left[i], far[next], right[next]});
  }
  return scalp;
}

}  // namespace hair::test

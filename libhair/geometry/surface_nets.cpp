#include <array>

#include <libhair/core/parallel.h>
#include <libhair/geometry/surface_nets.h>

namespace hair {
namespace {

glm::vec3 gradient(const ScalarField& field, glm::vec3 p) {
  constexpr float h = 2e-4f;
  return glm::vec3(field(p + glm::vec3(h, 0, 0)) - field(p - glm::vec3(h, 0, 0)),
                   field(p + glm::vec3(0, h, 0)) - field(p - glm::vec3(0, h, 0)),
                   field(p + glm::vec3(0, 0, h)) - field(p - glm::vec3(0, 0, h))) /
         (2 * h);
}

}  // namespace

TriangleMesh surfaceNets(const ScalarField& field, const Bounds& box, float cell) {
  const glm::ivec3 n = glm::ivec3(glm::ceil(box.size() / cell)) + 1;  // nodes an axis
  const std::array<std::size_t, 3> stride = {
      1, static_cast<std::size_t>(n.x),
      static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y)};
  const std::size_t slice = stride[2], slices = static_cast<std::size_t>(n.z);

  // Calls visit(c, its index) for every cell whose coordinates are at least `from`.
  const auto forCells = [&](int from, auto&& visit) {
    glm::ivec3 c;
    for (c.z = from; c.z + 1 < n.z; ++c.z)
      for (c.y = from; c.y + 1 < n.y; ++c.y)
        for (c.x = from; c.x + 1 < n.x; ++c.x)
          visit(c, static_cast<std::size_t>(c.x) + static_cast<std::size_t>(c.y) * stride[1] +
                       static_cast<std::size_t>(c.z) * stride[2]);
  };

  // Sample the field at every node.
  std::vector<float> value(slice * slices);
  parallelFor(slices, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * slice; i < end * slice; ++i) {
      const glm::vec3 node(i % stride[1], i % slice / stride[1], i / slice);
      value[i] = field(box.lower + cell * node);
    }
  });

  // Put a vertex in every cell with a change of sign, at the mean of its edge crossings.
  TriangleMesh mesh;
  std::vector<std::uint32_t> vertexOfCell(value.size(), ~0u);
  forCells(0, [&](glm::ivec3 c, std::size_t base) {
    glm::vec3 sum(0);
    int crossings = 0;
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis) {
        if (corner >> axis & 1) continue;
        glm::vec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
        std::size_t a = base;
        for (int k = 0; k < 3; ++k)
          a += at[k] > 0 ? stride[static_cast<std::size_t>(k)] : std::size_t{0};
        const float va = value[a], vb = value[a + stride[static_cast<std::size_t>(axis)]];
        if ((va < 0) == (vb < 0)) continue;
        at[axis] += va / (va - vb);
        sum += at;
        ++crossings;
      }
    if (crossings == 0) return;
    vertexOfCell[base] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(box.lower +
                             cell * (glm::vec3(c) + sum / static_cast<float>(crossings)));
  });

  // Move vertices onto the surface, a cell at the most.
  mesh.normals.resize(mesh.positions.size());
  parallelFor(mesh.positions.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      glm::vec3& p = mesh.positions[v];
      const glm::vec3 start = p;
      for (int step = 0; step < 4; ++step) {
        const glm::vec3 g = gradient(field, p);
        p -= field(p) * g / std::max(glm::dot(g, g), 0.1f);
      }
      if (glm::distance(p, start) > cell) p = start;
      const glm::vec3 g = gradient(field, p);
      mesh.normals[v] = glm::length(g) > 1e-6f ? glm::normalize(g) : glm::vec3(0, 1, 0);
    }
  });

  // Join the four cells around every grid edge that crosses the surface, split along the shorter
  // diagonal.
  forCells(1, [&](glm::ivec3, std::size_t i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool inside = value[i] < 0;
      if (inside == (value[i + stride[axis]] < 0)) continue;
      const std::size_t u = stride[(axis + 1) % 3], v = stride[(axis + 2) % 3];
      std::array<std::uint32_t, 4> q = {vertexOfCell[i - u - v], vertexOfCell[i - v],
                                        vertexOfCell[i], vertexOfCell[i - u]};
      if (!inside) std::swap(q[1], q[3]);
      const auto& p = mesh.positions;
      if (glm::distance(p[q[0]], p[q[2]]) <= glm::distance(p[q[1]], p[q[3]])) {
        mesh.triangles.emplace_back(q[0], q[1], q[2]);
        mesh.triangles.emplace_back(q[0], q[2], q[3]);
      } else {
        mesh.triangles.emplace_back(q[0], q[1], q[3]);
        mesh.triangles.emplace_back(q[1], q[2], q[3]);
      }
    }
  });
  return mesh;
}

}  // namespace hair

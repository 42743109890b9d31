#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/geometry/mesh_parts.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/geometry/triangle_distance.h>

namespace hair {
namespace {

using Corners = TriangleCorners;

// The triangles, and a fan to the middle of every hole. The border of a surface is a sum of cycles,
// so joining each unpaired edge to one point per hole closes it without walking the cycle.
std::vector<Corners> closedTriangles(const TriangleMesh& mesh) {
  const auto same = weldVertices(mesh.positions);
  std::vector<Corners> triangles;
  struct Edge {
    std::uint32_t low, high;
    bool forward;
    bool operator<(const Edge& o) const { return std::tie(low, high) < std::tie(o.low, o.high); }
  };
  std::vector<Edge> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> v = {same[t.x], same[t.y], same[t.z]};
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    triangles.push_back({mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  }
  std::sort(edges.begin(), edges.end());

  // Keep edges that faces use more often in one direction than in the other, and group them by
  // hole.
  std::vector<std::uint32_t> hole(mesh.positions.size());
  std::iota(hole.begin(), hole.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (hole[v] != v) v = hole[v] = hole[hole[v]];
    return v;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> border;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    int balance = 0;
    for (; j < edges.size() && !(edges[i] < edges[j]); ++j) balance += edges[j].forward ? 1 : -1;
    for (int k = 0; k < std::abs(balance); ++k)
      border.push_back(balance > 0 ? std::pair(edges[i].low, edges[i].high)
                                   : std::pair(edges[i].high, edges[i].low));
    if (balance != 0) hole[root(edges[i].low)] = root(edges[i].high);
    i = j;
  }
  std::vector<glm::vec4> middle(mesh.positions.size(), glm::vec4(0));
  for (const auto& [a, b] : border)
    middle[root(a)] += glm::vec4(0.5f * (mesh.positions[a] + mesh.positions[b]), 1);
  for (const auto& [a, b] : border) {
    const glm::vec4 m = middle[root(a)];
    triangles.push_back({mesh.positions[b], mesh.positions[a], glm::vec3(m) / m.w});
  }
  return triangles;
}

struct Grid {
  glm::vec3 lower;
  float cell;
  glm::ivec3 n;

  std::size_t index(glm::ivec3 i) const {
    return static_cast<std::size_t>(i.x) +
           static_cast<std::size_t>(n.x) *
               (static_cast<std::size_t>(i.y) +
                static_cast<std::size_t>(n.y) * static_cast<std::size_t>(i.z));
  }
  std::size_t size() const { return index({0, 0, n.z}); }
  glm::vec3 node(glm::ivec3 i) const { return lower + cell * glm::vec3(i); }
};

// The nearest triangle, and its squared distance.
struct Nearest {
  float squared = INFINITY;
  std::uint32_t triangle = ~0u;
};

void measure(Nearest& nearest, glm::vec3 p, std::span<const Corners> triangles, std::uint32_t t) {
  const float d = squaredDistance(p, triangles[t]);
  if (d < nearest.squared) nearest = {d, t};
}

// Exact distances at the nodes within two cells of each triangle's box.
void measureNear(const Grid& grid, std::span<const Corners> triangles,
                 std::vector<Nearest>& nearest) {
  parallelFor(static_cast<std::size_t>(grid.n.z), 4, [&](std::size_t begin, std::size_t end) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const glm::vec3 low = (glm::min(a, glm::min(b, c)) - grid.lower) / grid.cell - 2.0f;
      const glm::vec3 high = (glm::max(a, glm::max(b, c)) - grid.lower) / grid.cell + 2.0f;
      glm::ivec3 first = glm::max(glm::ivec3(glm::ceil(low)), 0);
      glm::ivec3 last = glm::min(glm::ivec3(glm::floor(high)), grid.n - 1);
      first.z = std::max(first.z, static_cast<int>(begin));
      last.z = std::min(last.z, static_cast<int>(end) - 1);
      for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
          for (int x = first.x; x <= last.x; ++x)
            measure(nearest[grid.index({x, y, z})], grid.node({x, y, z}), triangles, t);
    }
  });
}

// Propagates the nearest triangle from node to node, in the eight diagonal sweeps of the fast
// sweeping method (Zhao 2005), and measures the distance to it at each node.
void measureFar(const Grid& grid, std::span<const Corners> triangles,
                std::vector<Nearest>& nearest) {
  for (int sweep = 0; sweep < 8; ++sweep) {
    const glm::ivec3 step(sweep & 1 ? 1 : -1, sweep & 2 ? 1 : -1, sweep & 4 ? 1 : -1);
    const auto at = [&](int i, int axis) { return step[axis] > 0 ? i : grid.n[axis] - 1 - i; };
    for (int z = 0; z < grid.n.z; ++z)
      for (int y = 0; y < grid.n.y; ++y)
        for (int x = 0; x < grid.n.x; ++x) {
          const glm::ivec3 here(at(x, 0), at(y, 1), at(z, 2));
          Nearest& mine = nearest[grid.index(here)];
          if (mine.squared < 4 * grid.cell * grid.cell) continue;
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 there = here;
            there[axis] -= step[axis];
            if (there[axis] < 0 || there[axis] >= grid.n[axis]) continue;
            const Nearest theirs = nearest[grid.index(there)];
            if (theirs.triangle != ~0u && theirs.triangle != mine.triangle)
              measure(mine, grid.node(here), triangles, theirs.triangle);
          }
        }
  }
}

// The winding number of the surface around each node, counted along the grid lines of one axis:
// every triangle through which a line leaves the solid counts +1 for the nodes before it.
void windAlong(int axis, const Grid& grid, std::span<const Corners> triangles,
               std::vector<std::int8_t>& votes) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<int> winding(votes.size() + 1, 0);
  for (const Corners& t : triangles) {
    // Shift the lines off the nodes by an odd fraction of a cell, so that none meets an edge or a
    // vertex that lies on the grid.
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 q = (glm::dvec3(t[k]) - glm::dvec3(grid.lower)) / double{grid.cell};
      p[k] = {q[u] - 1.234567e-4, q[v] - 2.718281e-4, q[axis]};
    }
    const auto cross = [](glm::dvec3 a, glm::dvec3 b) { return a.x * b.y - a.y * b.x; };
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0) continue;
    const auto [u0, u1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [v0, v1] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int iv = std::max(0, static_cast<int>(std::ceil(v0))); iv <= std::min(grid.n[v] - 1.0, v1);
         ++iv)
      for (int iu = std::max(0, static_cast<int>(std::ceil(u0)));
           iu <= std::min(grid.n[u] - 1.0, u1); ++iu) {
        const glm::dvec3 q(iu, iv, 0);
        std::array<double, 3> w;
        for (std::size_t k = 0; k < 3; ++k)
          w[k] = cross(p[(k + 1) % 3] - q, p[(k + 2) % 3] - q) / area;
        if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
        const double depth = w[0] * p[0].z + w[1] * p[1].z + w[2] * p[2].z;
        const int last = std::min(static_cast<int>(std::floor(depth)), grid.n[axis] - 1);
        if (last < 0) continue;
        glm::ivec3 node;
        node[u] = iu, node[v] = iv, node[axis] = last;
        winding[grid.index(node)] += area > 0 ? 1 : -1;
      }
  }
  // Sum from the far end of every line.
  glm::ivec3 i;
  const int n = grid.n[axis];
  for (i[v] = 0; i[v] < grid.n[v]; ++i[v])
    for (i[u] = 0; i[u] < grid.n[u]; ++i[u]) {
      int sum = 0;
      for (i[axis] = n - 1; i[axis] >= 0; --i[axis]) {
        sum += winding[grid.index(i)];
        votes[grid.index(i)] = static_cast<std::int8_t>(votes[grid.index(i)] + (sum > 0));
      }
    }
}

}  // namespace

MeshSdf::MeshSdf(const TriangleMesh& mesh, float cell, float margin)
    : cell_(cell), perCell_(1.0f / cell), margin_(margin) {
  require(!mesh.triangles.empty(), "signed distance field: the mesh has no triangles");
  require(cell > 0 && margin > 0 && std::isfinite(cell + margin), "signed distance field: cell (",
          cell, " m) and margin (", margin, " m) must be positive");
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
            "signed distance field: vertex ", &p - mesh.positions.data(), " is not finite");
  for (const glm::uvec3& t : mesh.triangles)
    require(glm::max(t.x, glm::max(t.y, t.z)) < mesh.positions.size(),
            "signed distance field: triangle ", &t - mesh.triangles.data(), " of ",
            mesh.positions.size(), " vertices has none of them at a corner");
  // Of the corners alone: a vertex without a triangle is no surface.
  Bounds meshBox;
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) meshBox.extend(mesh.positions[t[k]]);
  const glm::vec3 count = glm::ceil((meshBox.size() + 2 * margin) / cell) + 1.0f;
  require(count.x * count.y * count.z < 0x1p27f, "signed distance field: ", count.x, " x ", count.y,
          " x ", count.z, " nodes are too many; take a larger cell than ", cell, " m");
  nodes_ = glm::max(glm::ivec3(count), 2);
  box_.lower = meshBox.centre() - 0.5f * cell * glm::vec3(nodes_ - 1);
  box_.upper = box_.lower + cell * glm::vec3(nodes_ - 1);

  const Grid grid{box_.lower, cell, nodes_};
  const auto triangles = closedTriangles(mesh);
  std::vector<Nearest> nearest(grid.size());
  measureNear(grid, triangles, nearest);
  measureFar(grid, triangles, nearest);
  std::vector<std::int8_t> votes(grid.size(), 0);
  for (int axis = 0; axis < 3; ++axis) windAlong(axis, grid, triangles, votes);

  distances_.resize(grid.size());
  gradients_.resize(grid.size());
  for (std::size_t i = 0; i < distances_.size(); ++i)
    distances_[i] = std::sqrt(nearest[i].squared) * (votes[i] >= 2 ? -1.0f : 1.0f);
  parallelFor(static_cast<std::size_t>(nodes_.z), 4, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 i;
    for (i.z = static_cast<int>(begin); i.z < static_cast<int>(end); ++i.z)
      for (i.y = 0; i.y < nodes_.y; ++i.y)
        for (i.x = 0; i.x < nodes_.x; ++i.x)
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 before = i, after = i;
            before[axis] = std::max(i[axis] - 1, 0);
            after[axis] = std::min(i[axis] + 1, nodes_[axis] - 1);
            gradients_[grid.index(i)][axis] =
                (distances_[grid.index(after)] - distances_[grid.index(before)]) /
                (cell * static_cast<float>(after[axis] - before[axis]));
          }
  });
}

namespace {

// The eight nodes around a point of the box, and their trilinear weights.
struct NodesAround {
  std::size_t first, dy, dz;
  glm::vec3 t;

  NodesAround(glm::vec3 q, glm::ivec3 nodes) {
    const glm::ivec3 i = glm::min(glm::ivec3(q), nodes - 2);
    t = q - glm::vec3(i);
    dy = static_cast<std::size_t>(nodes.x), dz = dy * static_cast<std::size_t>(nodes.y);
    first = static_cast<std::size_t>(i.x) + static_cast<std::size_t>(i.y) * dy +
            static_cast<std::size_t>(i.z) * dz;
  }
  template <class T>
  T mix(const std::vector<T>& values) const {
    const T* v = values.data() + first;
    const auto row = [&](const T* r) { return glm::mix(r[0], r[1], t.x); };
    return glm::mix(glm::mix(row(v), row(v + dy), t.y),
                    glm::mix(row(v + dz), row(v + dz + dy), t.y), t.z);
  }
};

}  // namespace

float MeshSdf::distance(glm::vec3 p) const {
  const glm::vec3 inBox = glm::clamp(p, box_.lower, box_.upper);
  if (inBox != p) return glm::distance(p, inBox) + margin_;
  return NodesAround((p - box_.lower) * perCell_, nodes_).mix(distances_);
}

glm::vec4 MeshSdf::distanceAndGradient(glm::vec3 p) const {
  const glm::vec3 inBox = glm::clamp(p, box_.lower, box_.upper);
  const bool inside = inBox == p;
  const NodesAround around((inBox - box_.lower) * perCell_, nodes_);
  const glm::vec3 way = inside ? around.mix(gradients_) : p - inBox;
  const float length = glm::length(way);
  return {length > 1e-6f ? way * (1.0f / length) : glm::vec3(0, 1, 0),
          inside ? around.mix(distances_) : length + margin_};
}

}  // namespace hair

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/geometry/surface_nets.h>

namespace hair {
namespace {

glm::vec3 randomPoint(std::uint32_t i, float reach) {
  return reach * (2.0f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 1.0f);
}

// A sphere of true points on the unit sphere's surface, times radius.
TriangleMesh sphere(float radius, int rings) {
  TriangleMesh mesh;
  const float pi = std::numbers::pi_v<float>;
  const int around = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int a = 0; a < around; ++a) {
      const float up = pi * static_cast<float>(r) / static_cast<float>(rings);
      const float turn = 2 * pi * static_cast<float>(a) / static_cast<float>(around);
      // Exactly one pole, so that the poles weld.
      const float out = r == 0 || r == rings ? 0 : std::sin(up);
      mesh.positions.push_back(radius *
                               glm::vec3(out * std::sin(turn), std::cos(up), out * std::cos(turn)));
    }
  const auto at = [&](int r, int a) { return static_cast<std::uint32_t>(r * around + a % around); };
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      mesh.triangles.emplace_back(at(r, a), at(r + 1, a), at(r + 1, a + 1));
      mesh.triangles.emplace_back(at(r, a), at(r + 1, a + 1), at(r, a + 1));
    }
  computeNormals(mesh);
  return mesh;
}

TriangleMesh box(glm::vec3 half) {
  TriangleMesh mesh;
  for (int c = 0; c < 8; ++c)
    mesh.positions.push_back(half * glm::vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1));
  for (glm::uvec4 q : {glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5), glm::uvec4(0, 1, 5, 4),
                       glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6)}) {
    mesh.triangles.emplace_back(q.x, q.y, q.z);
    mesh.triangles.emplace_back(q.x, q.z, q.w);
  }
  computeNormals(mesh);
  return mesh;
}

float boxDistance(glm::vec3 p, glm::vec3 half) {
  const glm::vec3 q = glm::abs(p) - half;
  return glm::length(glm::max(q, 0.0f)) + std::min(std::max({q.x, q.y, q.z}), 0.0f);
}

TEST(MeshSdf, ASphereIsAsFarAsItsRadiusSays) {
  const float radius = 0.1f, cell = 0.005f;
  const MeshSdf sdf(sphere(radius, 96), cell, 0.04f);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const glm::vec3 p = randomPoint(i, 0.13f);
    const float expected = glm::length(p) - radius;
    if (expected < -0.06f) continue;  // the grid does not resolve the middle's kink
    const glm::vec4 d = sdf.distanceAndGradient(p);
    ASSERT_NEAR(d.w, expected, (std::abs(expected) < 0.01f ? 0.05f : 0.15f) * cell);
    ASSERT_GT(glm::dot(glm::vec3(d), glm::normalize(p)), 0.995f);
    ASSERT_NEAR(glm::length(glm::vec3(d)), 1, 1e-5f);
  }
}

TEST(MeshSdf, ABoxIsExactButAtItsEdges) {
  const glm::vec3 half(0.08f, 0.05f, 0.065f);
  const float cell = 0.005f;
  const MeshSdf sdf(box(half), cell, 0.04f);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const glm::vec3 p = randomPoint(i, 0.085f);
    const float expected = boxDistance(p, half);
    // Where two sides are equally near, the kink inside a cell is cut by half a cell.
    ASSERT_NEAR(sdf.distance(p), expected, 0.55f * cell);
    if (expected > 0 || expected < -0.25f * cell) {
      ASSERT_EQ(sdf.distance(p) < 0, expected < 0);
    }
  }
}

TEST(MeshSdf, AnOpenTubeIsClosedByLids) {
  // The sphere without its caps: what is left of the solid has flat ends at the cut.
  const float radius = 0.1f, cell = 0.005f, cut = 0.06f;
  TriangleMesh mesh = sphere(radius, 96);
  float top = 0;
  std::erase_if(mesh.triangles, [&](glm::uvec3 t) {
    const float y = std::max({std::abs(mesh.positions[t.x].y), std::abs(mesh.positions[t.y].y),
                              std::abs(mesh.positions[t.z].y)});
    if (y <= cut) top = std::max(top, y);
    return y > cut;
  });
  const MeshSdf sdf(mesh, cell, 0.04f);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const glm::vec3 p = randomPoint(i, 0.13f);
    const float expected = std::max(glm::length(p) - radius, std::abs(p.y) - top);
    if (std::abs(expected) < 0.5f * cell) continue;
    ASSERT_EQ(sdf.distance(p) < 0, expected < 0) << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_NEAR(sdf.distance({0, top + 0.02f, 0}), 0.02f, 0.05f * cell);
}

TEST(MeshSdf, DistancesChangeByNoMoreThanTheWay) {
  // No slope along an axis exceeds 1, so none exceeds the square root of 3.
  const MeshSdf sdf(box({0.08f, 0.05f, 0.065f}), 0.005f, 0.06f);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const glm::vec3 a = randomPoint(i, 0.1f), b = a + randomPoint(i + 50000, 0.003f);
    ASSERT_LE(std::abs(sdf.distance(a) - sdf.distance(b)), 1.74f * glm::distance(a, b) + 1e-6f);
  }
}

TEST(MeshSdf, OutsideItsGridItNeverSaysTooFar) {
  const float radius = 0.1f, margin = 0.02f;
  const MeshSdf sdf(sphere(radius, 32), 0.005f, margin);
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = randomPoint(i, 1.0f);
    const glm::vec3 inBox = glm::clamp(p, sdf.box().lower, sdf.box().upper);
    if (inBox == p) continue;
    ASSERT_LE(sdf.distance(p), glm::length(p) - radius + 1e-3f);
    ASSERT_GE(sdf.distance(p), margin);
  }
}

TEST(MeshSdf, IsTheSameForAnyThreadCount) {
  const TriangleMesh mesh = sphere(0.1f, 24);
  const auto build = [&](int threads) {
    const ThreadLimit limit(threads);
    return MeshSdf(mesh, 0.006f, 0.03f);
  };
  const MeshSdf one = build(1), three = build(3);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const glm::vec3 p = randomPoint(i, 0.13f);
    ASSERT_EQ(one.distanceAndGradient(p), three.distanceAndGradient(p));
  }
}

TEST(MeshSdf, AnEmptyMeshAndAnAbsurdGridAreErrors) {
  EXPECT_THROW(MeshSdf(TriangleMesh{}, 0.005f, 0.01f), Error);
  EXPECT_THROW(MeshSdf(sphere(0.1f, 8), 1e-5f, 0.01f), Error);
  EXPECT_THROW(MeshSdf(sphere(0.1f, 8), 0, 0.01f), Error);
  TriangleMesh broken = sphere(0.1f, 8);
  broken.triangles[3].y = static_cast<std::uint32_t>(broken.positions.size());
  EXPECT_THROW(MeshSdf(broken, 0.005f, 0.01f), Error);
  broken = sphere(0.1f, 8);
  broken.positions[3].y = NAN;
  EXPECT_THROW(MeshSdf(broken, 0.005f, 0.01f), Error);
}

TEST(SurfaceNets, VerticesLieOnTheSurfaceAndItIsClosed) {
  const auto field = [](glm::vec3 p) { return glm::length(p - glm::vec3(0.01f, 0, 0)) - 0.1f; };
  const TriangleMesh mesh = surfaceNets(field, {glm::vec3(-0.13f), glm::vec3(0.13f)}, 0.01f);
  ASSERT_GT(mesh.triangles.size(), 500u);
  for (glm::vec3 p : mesh.positions) ASSERT_NEAR(field(p), 0, 1e-5f);
  // The signed volume is that of the sphere, so all triangles face outwards.
  double volume = 0;
  for (glm::uvec3 t : mesh.triangles)
    volume +=
        glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6.0;
  EXPECT_NEAR(volume, 4.0 / 3 * std::numbers::pi * 1e-3, 4e-5);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (glm::uvec3 t : mesh.triangles)
    for (int k = 0; k < 3; ++k) edges.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  for (auto [a, b] : edges)
    ASSERT_TRUE(std::binary_search(edges.begin(), edges.end(), std::pair(b, a)));
}

}  // namespace
}  // namespace hair

#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/geometry/mesh_sdf.h>

namespace hair {
namespace {

TriangleMesh wedge(float size) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

TEST(SharedSdf, IsOneForEqualMeshesAndAnotherForWhateverDiffers) {
  const TriangleMesh mesh = wedge(0.05f), copy = mesh;
  const auto sdf = sharedSdf(mesh, 4e-3f, 0.01f);
  EXPECT_EQ(sharedSdf(copy, 4e-3f, 0.01f), sdf);
  EXPECT_NE(sharedSdf(mesh, 5e-3f, 0.01f), sdf);
  EXPECT_NE(sharedSdf(mesh, 4e-3f, 0.02f), sdf);
  EXPECT_NE(sharedSdf(wedge(0.06f), 4e-3f, 0.01f), sdf);
  TriangleMesh open = mesh;
  open.triangles.pop_back();
  EXPECT_NE(sharedSdf(open, 4e-3f, 0.01f), sdf);
}

TEST(SharedSdf, GoesWithItsLastUser) {
  auto sdf = sharedSdf(wedge(0.04f), 4e-3f, 0.01f);
  const std::weak_ptr<const MeshSdf> seen = sdf;
  auto other = sharedSdf(wedge(0.04f), 4e-3f, 0.01f);
  sdf.reset();
  EXPECT_FALSE(seen.expired());
  other.reset();
  EXPECT_TRUE(seen.expired());
  EXPECT_NE(sharedSdf(wedge(0.04f), 4e-3f, 0.01f), nullptr);
}

TEST(SharedSdf, IsOneForAllThreadsThatAskAtOnce) {
  std::vector<std::shared_ptr<const MeshSdf>> got(8);
  std::vector<std::thread> threads;
  for (auto& sdf : got)
    threads.emplace_back([&sdf] { sdf = sharedSdf(wedge(0.03f), 2e-3f, 0.01f); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& sdf : got) EXPECT_EQ(sdf, got[0]);
}

}  // namespace
}  // namespace hair

#include <libhair/hair_mesh/operations.h>

#include <gtest/gtest.h>

#include <numeric>

#include <tests/hair_mesh/sample_meshes.h>

namespace hair {

TEST(HairMeshOperations, ExtrudeGrowsOneLayer) {
  HairMesh mesh = makeHairMesh(test::gridScalp(3, 2));
  std::vector<std::uint32_t> all(6);
  std::iota(all.begin(), all.end(), 0u);
  extrudeFaces(all, -0.03f, mesh);
  extrudeFaces(all, 0.03f, mesh);
  EXPECT_EQ(mesh.layers[1].vertexCount(), 12u);
  EXPECT_FLOAT_EQ(mesh.layers[1].positions[0].y, -0.03f);
  deleteFaces(all, mesh);
  deleteFaces(all, mesh);
  EXPECT_EQ(mesh.layerCount(), 1u);
}
}  // namespace hair

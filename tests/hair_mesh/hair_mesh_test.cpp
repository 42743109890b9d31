#include <libhair/hair_mesh/hair_mesh.h>

#include <gtest/gtest.h>

#include <tests/hair_mesh/sample_meshes.h>

namespace hair {

TEST(HairMesh, HasAFaceOfEachBundleInEachLayerUpToItsTip) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 2), 4);
  EXPECT_EQ(mesh.bundleCount(), 6u);
  EXPECT_EQ(mesh.layerCount(), 5u);
  EXPECT_EQ(mesh.vertexCount(), 5u * 12u);
  EXPECT_EQ(mesh.sides(5), 4u);
  EXPECT_EQ(whyInvalid(mesh), "");
}

}  // namespace hair

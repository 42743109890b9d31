#include <libhair/hair_mesh/mesh_groom.h>

#include <gtest/gtest.h>

#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

TEST(HairMeshChains, AStackHasOneForEachVertexOfItsTip) {
  const HairMesh mesh = test::stack(test::gridScalp(5, 4), 4);
  const HairMeshChains chains = chainsOf(mesh);
  // The mesh of the paper's figure 12: 150 vertices in 5 layers.
  EXPECT_EQ(mesh.vertexCount(), 150u);
  EXPECT_EQ(chains.chainCount(), 30u);
  EXPECT_EQ(chains.linkCount(), 120u);
}

TEST(HairMeshChains, StandsOnTheVerticesBelowItsEnd) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 3), 3);
  const HairMeshChains chains = chainsOf(mesh);
  for (std::uint32_t c = 0; c < mesh.cornerCount(); ++c) {
    const auto chain = chains.chain(chains.chainOfCorner[c]);
    ASSERT_EQ(chain.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(chain[k], mesh.layers[k].corners[c]);
  }
}

TEST(HairMeshChains, EndWhereTheirBundleEndsThoughANeighbourGoesOn) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  // Bundle 1 goes one layer further, on vertices of its own.
  HairMesh::Layer top;
  top.corners.assign(mesh.cornerCount(), kNoVertex);
  for (std::uint32_t c = mesh.firstCorner[1]; c < mesh.firstCorner[2]; ++c) {
    top.corners[c] = static_cast<std::uint32_t>(top.positions.size());
    const std::uint32_t under = mesh.layers[1].corners[c];
    top.below.push_back(under);
    top.positions.push_back(mesh.layers[1].positions[under] + glm::vec3(0, 0.03f, 0));
    top.pinned.push_back(0);
  }
  mesh.layers.push_back(top);
  mesh.lastLayer[1] = 2;
  ASSERT_EQ(whyInvalid(mesh), "");

  const HairMeshChains chains = chainsOf(mesh);
  EXPECT_EQ(chains.chainCount(), 8u);  // two vertices are inside a long chain, and end a short one
  EXPECT_EQ(chains.linkCount(), 4u * 1 + 4u * 2);
  for (std::uint32_t c = 0; c < mesh.cornerCount(); ++c)
    EXPECT_EQ(chains.chain(chains.chainOfCorner[c]).size(), c < mesh.firstCorner[1] ? 2u : 3u);
}

TEST(HairMeshChains, BundlesWithoutLengthHaveNone) {
  const HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  const HairMeshChains chains = chainsOf(mesh);
  EXPECT_EQ(chains.chainCount(), 0u);
  EXPECT_EQ(chains.linkCount(), 0u);
  for (const std::uint32_t chain : chains.chainOfCorner) EXPECT_EQ(chain, kNoVertex);
}

}  // namespace
}  // namespace hair

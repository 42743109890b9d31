#include <libhair/hair_mesh/mesh_groom.h>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/simulation/frame.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

struct Grown {
  HairMesh mesh;
  HairMeshRoots roots;
  StrandSet strands;
  Groom groom;
};

// Leans over, so that gravity has something to bend.
Grown grown(std::uint32_t columns = 5, std::uint32_t rows = 4) {
  Grown g;
  g.mesh = test::stack(test::gridScalp(columns, rows), 4, {0.02f, 0.03f, 0.005f});
  g.roots = placeRoots(g.mesh, {.strands = 300});
  traceStrands(g.mesh, g.roots, 24, g.strands);
  g.groom = makeGroom(g.mesh, {&g.roots, 1}, g.strands);
  return g;
}

TEST(MeshGroom, ChainsAreGuidesWithEqualLinksFromScalpToTip) {
  const Grown g = grown();
  const HairMeshChains chains = chainsOf(g.mesh);
  ASSERT_EQ(g.groom.guideCount(), chains.chainCount());
  for (std::size_t c = 0; c < chains.chainCount(); ++c) {
    const auto guide = g.groom.guide(c);
    const auto chain = chains.chain(c);
    EXPECT_EQ(guide.front(), g.mesh.layers.front().positions[chain.front()]);
    EXPECT_LT(glm::distance(guide.back(), g.mesh.layers.back().positions[chain.back()]), 1e-5f);
    const float link = glm::distance(guide[0], guide[1]);
    for (std::size_t k = 1; k + 1 < guide.size(); ++k)
      EXPECT_NEAR(glm::distance(guide[k], guide[k + 1]), link, 1e-4f * link);
  }
}

TEST(MeshGroom, AtRestTheStrandsAreThoseOfTheMesh) {
  const Grown g = grown();
  const Hair hair(g.groom, {}, {});
  ASSERT_EQ(hair.strands().pointCount(), g.strands.pointCount());
  for (std::size_t p = 0; p < g.strands.pointCount(); ++p)
    ASSERT_LT(glm::distance(hair.strands().points[p], g.strands.points[p]), 1e-6f) << p;
}

TEST(MeshGroom, StandsStillWhereItWasModelled) {
  const Grown g = grown();
  FrameSettings settings;
  settings.shadow = settings.shade = false;
  Hair hair(g.groom, settings, {});
  FrameProfile profile{};
  for (int f = 0; f < 60; ++f) frame({}, settings, 1.0f / 60, hair, profile);
  for (std::size_t p = 0; p < g.strands.pointCount(); ++p)
    ASSERT_LT(glm::distance(hair.strands().points[p], g.strands.points[p]), 1e-4f) << p;
}

// Of a face's corners only three lead a strand: what that costs while hair moves is bounded by how
// differently the corners move.
TEST(MeshGroom, StrandsFollowTheMeshThatMovesWithItsChains) {
  Grown g = grown();
  FrameSettings settings;
  settings.shadow = settings.shade = settings.selfCollision = false;
  Hair hair(g.groom, settings, {});
  FrameProfile profile{};
  RigidTransform head;
  for (int f = 1; f <= 20; ++f) {
    head.translation.x = 0.1f * std::sin(0.3f * static_cast<float>(f));
    frame({head, {}}, settings, 1.0f / 60, hair, profile);
  }
  // What the paper's way makes of it: the mesh's vertices moved with the chains, strands anew.
  std::vector<glm::vec3> points(g.groom.guidePoints.size());
  hair.guides.copyPoints(points);
  HairMesh moved = g.mesh;
  followGuides(g.mesh, chainsOf(g.mesh), points, g.groom.pointsPerGuide, moved);
  float farthest = 0, motion = 0;
  for (std::size_t k = 0; k < moved.layerCount(); ++k)
    for (std::uint32_t v = 0; v < moved.layers[k].vertexCount(); ++v)
      motion = std::max(motion,
                        glm::distance(moved.layers[k].positions[v], g.mesh.layers[k].positions[v]));
  StrandSet traced;
  traceStrands(moved, g.roots, 2, traced);  // roots and tips: exact in both
  for (std::size_t s = 0; s < traced.strandCount(); ++s)
    farthest =
        std::max(farthest, glm::distance(traced.strand(s).back(), hair.strands().strand(s).back()));
  EXPECT_GT(motion, 0.02f);
  EXPECT_LT(farthest, 0.03f * motion) << motion;  // measured: 0.022
}

TEST(MeshGroom, VerticesFollowTheirGuides) {
  const Grown g = grown();
  const HairMeshChains chains = chainsOf(g.mesh);
  HairMesh moved = g.mesh;
  followGuides(g.mesh, chains, g.groom.guidePoints, g.groom.pointsPerGuide, moved);
  for (std::size_t k = 0; k < moved.layerCount(); ++k)
    for (std::uint32_t v = 0; v < moved.layers[k].vertexCount(); ++v)
      ASSERT_LT(glm::distance(moved.layers[k].positions[v], g.mesh.layers[k].positions[v]), 1e-5f);
  std::vector<glm::vec3> shifted = g.groom.guidePoints;
  for (glm::vec3& p : shifted) p.x += 1;
  followGuides(g.mesh, chains, shifted, g.groom.pointsPerGuide, moved);
  EXPECT_NEAR(moved.layers[2].positions[3].x, g.mesh.layers[2].positions[3].x + 1, 1e-5f);
  EXPECT_THROW(followGuides(g.mesh, chains, shifted, 15, moved), Error);
}

TEST(MeshGroom, TiesHoldChainsUpToTheirLayer) {
  const Grown g = grown(2, 1);  // two bundles side by side, of 5 layers
  const Groom groom = makeGroom(g.mesh, {&g.roots, 1}, g.strands, {.tied = {2, 0}});
  const HairMeshChains chains = chainsOf(g.mesh);
  ASSERT_EQ(groom.tied.size(), chains.chainCount());
  std::vector<std::uint32_t> expected(chains.chainCount(), 1);
  for (std::uint32_t c = g.mesh.firstCorner[0]; c < g.mesh.firstCorner[1]; ++c)
    expected[chains.chainOfCorner[c]] = 8;  // layer 2 of 4 is at 7.5 of 15 links
  EXPECT_EQ(groom.tied, expected);
  EXPECT_THROW(makeGroom(g.mesh, {&g.roots, 1}, g.strands, {.tied = {2}}), Error);
}

TEST(MeshGroom, SaysWhatCannotBeSimulated) {
  Grown g = grown();
  StrandSet fewer;
  fewer.append(g.strands.strand(0));
  EXPECT_THROW(makeGroom(g.mesh, {&g.roots, 1}, fewer), Error);
  EXPECT_THROW(makeGroom(g.mesh, {&g.roots, 1}, g.strands, {.pointsPerGuide = 2}), Error);
  for (std::size_t k = 1; k < g.mesh.layerCount(); ++k)
    g.mesh.layers[k].positions[7] = g.mesh.layers[0].positions[7];
  try {
    makeGroom(g.mesh, {&g.roots, 1}, g.strands);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 7 of the scalp"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace hair

#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/surface.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <tests/hair_mesh/placement_samples.h>

namespace hair {
namespace {

// Of a stack on a grid of so many columns of faces, vertices that are not exterior, layer by layer,
// each named by where it stands: its column plus (columns + 1) times its row; ascending.
std::vector<std::vector<std::uint32_t>> inside(const HairMesh& mesh, std::uint32_t columns) {
  const auto exterior = exteriorVertices(mesh);
  std::vector<std::vector<std::uint32_t>> found;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k) {
    found.emplace_back();
    for (std::size_t v = 0; v < exterior[k].size(); ++v) {
      const glm::vec3 p = mesh.layers[k].positions[v] / 0.02f;
      const auto x = std::lround(p.x), z = std::lround(p.z);
      if (exterior[k][v] == 0)
        found.back().push_back(static_cast<std::uint32_t>(x + (columns + 1) * z));
    }
    std::sort(found.back().begin(), found.back().end());
  }
  return found;
}

using Layers = std::vector<std::vector<std::uint32_t>>;

TEST(ExteriorVertices, AreAllOfAScalp) {
  EXPECT_EQ(inside(makeHairMesh(test::gridScalp(3, 3)), 3), (Layers{{}}));
}

TEST(ExteriorVertices, AreAllOfOneLayerOnAScalp) {
  EXPECT_EQ(inside(test::stack(test::gridScalp(3, 3), 1), 3), (Layers{{}, {}}));
}

TEST(ExteriorVertices, AreScalpTipsAndSidesOfAStack) {
  EXPECT_EQ(inside(test::stack(test::gridScalp(3, 2), 4), 3),
            (Layers{{}, {5, 6}, {5, 6}, {5, 6}, {}}));
}

TEST(ExteriorVertices, AreScalpAndTipsAloneWhereTheScalpIsClosed) {
  const HairMesh mesh = test::ball(3, 3);
  const auto exterior = exteriorVertices(mesh);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(exterior[k], std::vector<std::uint8_t>(mesh.layers[k].vertexCount(), k % 3 == 0));
}

// 2 x 2 bundles, vertex 3 z + x. From layer 3 up columns 0 and 1 have parted, figure 2a: the
// quads from 2 to 3 along the cut are sides, and so is the middle of layer 2.
TEST(ExteriorVertices, AreThoseAlongAForkFromTheLayerBelowIt) {
  const HairMesh mesh = test::forked(
      test::stack(test::gridScalp(2, 2), 4), 3,
      [](glm::vec3 p) { return std::abs(p.x - 0.02f) < 1e-4f; },
      [](std::size_t j) { return j % 2 == 1; });
  ASSERT_EQ(mesh.layers[3].vertexCount(), 12u);
  EXPECT_EQ(inside(mesh, 2), (Layers{{}, {4}, {}, {}, {}}));
}

// 4 x 2 bundles, vertex 5 z + x: what is not along the cut, x = 2, stays inside.
TEST(ExteriorVertices, AreNotThoseBesideAFork) {
  const HairMesh mesh = test::forked(
      test::stack(test::gridScalp(4, 2), 4), 3,
      [](glm::vec3 p) { return std::abs(p.x - 0.04f) < 1e-4f; },
      [](std::size_t j) { return j % 4 >= 2; });
  EXPECT_EQ(inside(mesh, 4), (Layers{{}, {6, 7, 8}, {6, 8}, {6, 8}, {}}));
}

// 3 x 3 bundles, vertex 4 z + x; the one in the middle ends in layer 2 of 4: a hole from there
// on.
TEST(ExteriorVertices, AreThoseAroundABundleThatEndsEarly) {
  const HairMesh mesh = test::ending(test::stack(test::gridScalp(3, 3), 4), 4, 2);
  EXPECT_EQ(inside(mesh, 3), (Layers{{}, {5, 6, 9, 10}, {}, {}, {}}));
}

TEST(ExteriorVertices, DoNotDependOnHowManySidesFacesHave) {
  const HairMesh mesh = test::stack(test::plate(5), 3);
  const auto exterior = exteriorVertices(mesh);
  for (const std::size_t k : {1u, 2u})
    for (std::size_t v = 0; v < 16; ++v)
      EXPECT_EQ(exterior[k][v] != 0, glm::length(mesh.layers[0].positions[v]) > 0.08f) << k << v;
}

}  // namespace
}  // namespace hair

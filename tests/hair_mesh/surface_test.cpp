#include <libhair/hair_mesh/surface.h>

#include <gtest/gtest.h>

#include <libhair/hair_mesh/exterior.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

// The volume under a closed surface, by the divergence theorem.
float volume(const TriangleMesh& mesh) {
  float six = 0;
  for (const glm::uvec3 t : mesh.triangles)
    six += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  return six / 6;
}

TEST(OuterSurface, ClosesTheVolumeButForTheScalpWithItsOutsideOut) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 2, 0.02f), 2, {0, 0.03f, 0});
  const TriangleMesh surface = outerSurface(mesh);
  // The scalp lies in y = 0, through the origin: what is missing there adds nothing.
  EXPECT_NEAR(volume(surface), 0.06f * 0.04f * 0.06f, 1e-9f);
  // Six tips and two rings of ten sides, of four triangles each.
  EXPECT_EQ(surface.triangles.size(), 4u * (6 + 2 * 10));
  for (const glm::uvec3 t : surface.triangles) {
    const glm::vec3 n = glm::cross(surface.positions[t.y] - surface.positions[t.x],
                                   surface.positions[t.z] - surface.positions[t.x]);
    EXPECT_GT(glm::dot(n, surface.normals[t.x]), 0.99f * glm::length(n));
  }
}

TEST(OuterSurface, SidesBetweenBundlesAreInside) {
  const HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  std::size_t outer = 0;
  const auto quads = prismSides(mesh, 1);
  for (const PrismSide& quad : quads) outer += quad.outer;
  EXPECT_EQ(quads.size(), 7u);
  EXPECT_EQ(outer, 6u);
}

TEST(HairMeshLines, AreTheEdgesOfFacesAndOfChains) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 2), 4);
  // 3 x 2 quads have 17 edges, on 12 vertices.
  EXPECT_EQ(linesOf(mesh).size(), 5u * 17 + 4u * 12);
}

}  // namespace
}  // namespace hair

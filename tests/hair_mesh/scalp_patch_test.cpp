#include <libhair/hair_mesh/scalp_patch.h>
#include <libhair/model/scalp_roots.h>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/model/head.h>

namespace hair {
namespace {

// Twice the area of a face, along its normal.
glm::vec3 areaOf(const PolygonMesh& mesh, std::size_t f) {
  glm::vec3 sum(0);
  const auto face = mesh.face(f);
  for (std::size_t i = 0; i < face.size(); ++i)
    sum += glm::cross(mesh.positions[face[i]], mesh.positions[face[(i + 1) % face.size()]]);
  return sum;
}

TEST(ScalpPatch, OfTheHeadLiesOnItAndEndsAtTheHairline) {
  for (const float parting : {0.0f, 0.016f, -0.03f})
    for (const ScalpPatch patch : {ScalpPatch{1, 8}, ScalpPatch{4, 16}, ScalpPatch{9, 40}}) {
      const PolygonMesh mesh = headScalp(patch, {.x = parting});
      ASSERT_EQ(mesh.positions.size(), 1 + patch.rings * patch.sectors);
      ASSERT_EQ(mesh.faceCount(), patch.rings * patch.sectors);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::vec3 p = mesh.positions[v];
        EXPECT_LT(std::abs(headField(p)), 5e-6f) << v;
        const bool last = v >= mesh.positions.size() - patch.sectors;
        EXPECT_NEAR(scalpMask(p), last ? 0.5f : 0.8f, last ? 0.02f : 0.3f) << v;
      }
      for (std::size_t f = 0; f < mesh.faceCount(); ++f)
        EXPECT_GT(glm::dot(areaOf(mesh, f), mesh.positions[mesh.face(f)[0]] - kSkullMiddle), 0)
            << f;
      EXPECT_EQ(makeHairMesh(mesh).bundleCount(), mesh.faceCount());
    }
}

TEST(ScalpPatch, EdgesLeadAlongThePartingFromTheWhorlToTheFront) {
  const Parting parting{.x = 0.02f, .whorlZ = -0.02f};
  const PolygonMesh mesh = headScalp({6, 24}, parting);
  float z = mesh.positions[0].z;
  EXPECT_NEAR(z, parting.whorlZ, 5e-3f);
  EXPECT_NEAR(mesh.positions[0].x, parting.x, 1e-4f);
  for (std::size_t ring = 0; ring < 6; ++ring) {
    const glm::vec3 p = mesh.positions[1 + 24 * ring];
    EXPECT_NEAR(p.x, parting.x, 1e-4f);
    EXPECT_GT(p.z, z);
    z = p.z;
  }
}

TEST(ScalpPatch, OfASphereHasItsRadius) {
  const PolygonMesh mesh = sphereScalp({3, 12}, 0.1f, 100);
  for (const glm::vec3 p : mesh.positions) EXPECT_NEAR(glm::length(p), 0.1f, 1e-6f);
  EXPECT_NEAR(mesh.positions.back().y, 0.1f * std::cos(100 * 3.14159265f / 180), 1e-6f);
  EXPECT_EQ(makeHairMesh(mesh).bundleCount(), 36u);
  EXPECT_THROW(sphereScalp({0, 12}, 0.1f, 100), Error);
  EXPECT_THROW(sphereScalp({3, 2}, 0.1f, 100), Error);
  EXPECT_THROW(headScalp({3, 8}, {.x = 0.5f}), Error);
}

}  // namespace
}  // namespace hair

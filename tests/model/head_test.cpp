#include <algorithm>

#include <gtest/gtest.h>

#include <libhair/core/strands.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/head.h>

namespace hair {
namespace {

TEST(Head, HasTheProportionsOfAHead) {
  const Head head = builtinHead();
  EXPECT_GT(head.mesh.triangles.size(), 10'000u);
  EXPECT_LT(head.mesh.triangles.size(), 30'000u);
  Bounds skull, neck;
  float chin = 1;
  for (glm::vec3 p : head.mesh.positions) {
    if (p.y > 0.12f) skull.extend(p);
    if (p.y < -0.07f && p.y > -0.09f) neck.extend(p);
    if (p.z > 0.07f) chin = std::min(chin, p.y);
  }
  EXPECT_NEAR(skull.upper.y - chin, 0.225f, 0.01f);  // chin to crown
  EXPECT_NEAR(skull.size().x, 0.15f, 0.01f);
  EXPECT_NEAR(skull.size().z, 0.19f, 0.01f);
  EXPECT_NEAR(0.5f * neck.size().x, 0.05f, 0.004f);  // meets a body's neck
  EXPECT_NEAR(bounds(head.mesh.positions).lower.y, -0.11f, 0.002f);
}

TEST(Head, IsItsOwnMirrorImage) {
  for (float y = -0.1f; y < 0.2f; y += 0.013f)
    for (float z = -0.11f; z < 0.12f; z += 0.013f)
      for (float x = 0; x < 0.09f; x += 0.013f) {
        ASSERT_EQ(headField({x, y, z}), headField({-x, y, z}));
        ASSERT_EQ(scalpMask({x, y, z}), scalpMask({-x, y, z}));
      }
}

TEST(Head, MeshLiesOnTheFieldWithNormalsOutwards) {
  const Head head = builtinHead();
  const MeshSdf sdf(head.mesh, 0.004f, 0.02f);
  std::size_t off = 0;
  for (std::size_t v = 0; v < head.mesh.positions.size(); ++v) {
    const glm::vec3 p = head.mesh.positions[v], n = head.mesh.normals[v];
    off += std::abs(headField(p)) > 3e-4f;
    ASSERT_NEAR(glm::length(n), 1, 1e-4f);
    if (scalpMask(p) > 0.5f) {
      ASSERT_GT(sdf.distance(p + 0.005f * n), 0.002f);
      ASSERT_LT(sdf.distance(p - 0.005f * n), -0.002f);
    }
  }
  EXPECT_LT(off, head.mesh.positions.size() / 100);
}

TEST(Head, HairGrowsOnTheScalpAndNowhereElse) {
  const auto mask = [](glm::vec3 ray) {  // from the middle of the skull
    glm::vec3 p(0, 0.1f, 0);
    for (int step = 0; step < 200; ++step) p += 0.5f * -std::min(headField(p), -1e-5f) * ray;
    return scalpMask(p);
  };
  EXPECT_EQ(mask({0, 1, 0}), 1);
  EXPECT_EQ(mask({0, 0, -1}), 1);
  EXPECT_EQ(mask(glm::normalize(glm::vec3(0, -0.6f, -1))), 1);       // nape
  EXPECT_EQ(mask(glm::normalize(glm::vec3(1, 0.4f, 0))), 1);         // temple, above the ear
  EXPECT_EQ(mask({0, 0, 1}), 0);                                     // between the eyes
  EXPECT_EQ(mask(glm::normalize(glm::vec3(0, 0.3f, 1))), 0);         // forehead
  EXPECT_EQ(mask(glm::normalize(glm::vec3(0.7f, -0.5f, 0.7f))), 0);  // cheek
  EXPECT_EQ(scalpMask({0.08f, 0.075f, -0.006f}), 0);                 // ear
  EXPECT_EQ(scalpMask({0, -0.06f, -0.06f}), 0);                      // neck
}

}  // namespace
}  // namespace hair

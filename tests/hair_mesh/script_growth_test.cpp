#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <set>

#include <libhair/core/parallel.h>
#include <libhair/hair_mesh/script/script.h>
#include <libhair/model/head.h>
#include <libhair/model/scalp_roots.h>
#include <tests/hair_mesh/same_mesh.h>

namespace hair {
namespace {

// Of the corners of its faces.
glm::vec3 middleOfLayer(const HairMesh& mesh, std::size_t k) {
  glm::vec3 sum(0);
  float count = 0;
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    for (const std::uint32_t v : mesh.face(k, j)) sum += mesh.layers[k].positions[v], ++count;
  return sum / count;
}

HairMesh meshOf(const std::string& script) {
  return applyScript(parseHairMeshScript(script, "a.hairmesh")).mesh;
}

const std::string kParted = "scalp head 4 16\nextrude all 0.005\nseparate parting\n";

TEST(ScriptGrowth, CombedHairPartsAndLiesOutsideOfTheHead) {
  const HairMesh mesh = meshOf(kParted + "comb all 8 length 0.3 volume 0.02\n");
  ASSERT_EQ(mesh.layerCount(), 9u);
  EXPECT_EQ(whyInvalid(mesh), "");
  for (std::size_t k = 1; k < mesh.layerCount(); ++k)
    for (const glm::vec3 p : mesh.layers[k].positions) EXPECT_GT(headField(p), 1e-3f) << k;
  // The parted vertices, from the front to the whorl, fall to their own sides.
  for (std::uint32_t ring = 1; ring < 4; ++ring) {
    const std::uint32_t right = 16 * ring, left = right + 15;
    EXPECT_GT(mesh.layers[4].positions[mesh.face(4, right)[0]].x, 0.03f) << ring;
    EXPECT_LT(mesh.layers[4].positions[mesh.face(4, left)[3]].x, -0.01f) << ring;
    EXPECT_EQ(mesh.face(0, right)[0], mesh.face(0, left)[3]) << ring;
  }
}

TEST(ScriptGrowth, HairAroundASeparatedWhorlFallsToItsOwnSide) {
  for (const char* sectors : {"16", "15"}) {
    const HairMesh mesh = meshOf("scalp head 4 " + std::string(sectors) +
                                 "\nextrude all 0.005\nseparate parting\nseparate whorl\n"
                                 "comb all 8 length 0.3 volume 0.02\n");
    EXPECT_EQ(whyInvalid(mesh), "");
    // Corner 0 of the triangles of ring 0 is the whorl, below the parting's end.
    std::set<std::uint32_t> whorls;
    for (std::uint32_t s = 0; s < std::stoul(sectors); ++s) {
      EXPECT_EQ(mesh.face(0, s)[0], mesh.face(0, 0)[0]);
      whorls.insert(mesh.face(4, s)[0]);
    }
    EXPECT_EQ(whorls.size(), std::stoul(sectors));
    EXPECT_GT(mesh.layers[5].positions[mesh.face(5, 2)[0]].x, 0.05f);
    EXPECT_LT(mesh.layers[5].positions[mesh.face(5, 12)[0]].x, -0.05f);
    EXPECT_LT(mesh.layers[5].positions[mesh.face(5, 7)[0]].z, -0.05f);
  }
}

TEST(ScriptGrowth, CombedHairIsAsLongAsToldOrEndsAtItsCut) {
  const HairMesh mesh = meshOf(kParted + "comb all 30 length 0.2\n");
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j) {
    float length = 0;
    for (std::size_t k = 1; k < mesh.layerCount(); ++k)
      length += glm::distance(mesh.layers[k].positions[mesh.face(k, j)[1]],
                              mesh.layers[k - 1].positions[mesh.face(k - 1, j)[1]]);
    EXPECT_NEAR(length, 0.2f, 0.012f) << j;
  }
  const HairMesh cut = meshOf(kParted + "comb all 10 length 0.6 cut -0.05 -0.08 least 0.01\n");
  for (const glm::vec3 p : cut.layers.back().positions)
    EXPECT_NEAR(p.y, p.z > 0 ? -0.05f : -0.07f, 0.025f);
}

TEST(ScriptGrowth, PulledHairEndsInADisc) {
  const HairMesh mesh =
      meshOf("scalp head 4 16\npull all 6 to 0 0.15 -0.13 axis 0 0 -1 radius 0.02 volume 0.01\n");
  const glm::vec3 to(0, 0.15f, -0.13f);
  float most = 0;
  for (const glm::vec3 p : mesh.layers.back().positions) {
    EXPECT_NEAR(p.z, to.z, 1e-5f);
    most = std::max(most, glm::distance(p, to));
  }
  EXPECT_NEAR(most, 0.02f, 1e-5f);
  // The farther a root, the farther out its hair.
  const glm::vec3 pole = glm::normalize(to - kSkullMiddle);
  std::vector<float> angles;
  for (const glm::vec3 p : mesh.layers[0].positions)
    angles.push_back(std::acos(glm::dot(glm::normalize(p - kSkullMiddle), pole)));
  const float farthest = *std::max_element(angles.begin(), angles.end());
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::size_t i = 0; i < mesh.sides(j); ++i)
      EXPECT_NEAR(glm::distance(mesh.layers.back().positions[mesh.face(6, j)[i]], to),
                  0.02f * angles[mesh.face(0, j)[i]] / farthest, 1e-5f);
  for (const glm::vec3 p : mesh.layers[3].positions) EXPECT_GT(headField(p), 1e-3f);
}

TEST(ScriptGrowth, ASweptSectionKeepsItsShapeAndGoesThroughItsPoints) {
  const std::string start = "scalp sphere 0.1 2 8\nextrude all 0.02\n";
  const HairMesh mesh = meshOf(start + "sweep all 40 scale 0.5 through 0 0.2 0.1 0 0.1 0.3\n");
  const auto& from = mesh.layers[1].positions;
  const auto& to = mesh.layers.back().positions;
  ASSERT_EQ(from.size(), to.size());
  for (std::size_t a = 0; a < from.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_NEAR(glm::distance(to[a], to[b]), 0.5f * glm::distance(from[a], from[b]), 1e-5f);
  const auto middleOf = [&](std::size_t k) { return middleOfLayer(mesh, k); };
  EXPECT_LT(glm::distance(middleOf(41), {0, 0.1f, 0.3f}), 1e-3f);
  glm::vec3 normal(0);  // of the last section: along the path
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::size_t i = 0; i < mesh.sides(j); ++i)
      normal += glm::cross(to[mesh.face(41, j)[i]], to[mesh.face(41, j)[(i + 1) % mesh.sides(j)]]);
  EXPECT_GT(glm::dot(glm::normalize(normal), glm::normalize(middleOf(41) - middleOf(40))), 0.999f);
  float nearest = 1;
  for (std::size_t k = 1; k < 42; ++k)
    nearest = std::min(nearest, glm::distance(middleOf(k), {0, 0.2f, 0.1f}));
  EXPECT_LT(nearest, 6e-3f);
}

TEST(ScriptGrowth, ACoilGoesAroundItsAxis) {
  const HairMesh mesh = meshOf(
      "scalp sphere 0.01 1 6 to 60\n"
      "coil all 40 about 0.05 0 0 axis 0 1 0 turns 1 rise 0.04\n");
  const auto middleOf = [&](std::size_t k) { return middleOfLayer(mesh, k); };
  for (std::size_t k = 0; k < 41; ++k) {
    const glm::vec3 p = middleOf(k) - glm::vec3(0.05f, 0, 0);
    EXPECT_NEAR(std::hypot(p.x, p.z), 0.05f, 1e-3f) << k;
  }
  EXPECT_NEAR(middleOf(40).y - middleOf(0).y, 0.04f, 1e-4f);
  EXPECT_LT(glm::distance(middleOf(40), middleOf(0) + glm::vec3(0, 0.04f, 0)), 1e-3f);
}

TEST(ScriptGrowth, DrapedHairHangsDownBesideTheHead) {
  const HairMesh mesh = meshOf("scalp sphere 0.1 3 12\ndrape all 10 length 0.4 volume 0.02\n");
  for (std::size_t k = 1; k < 11; ++k)
    for (const glm::vec3 p : mesh.layers[k].positions) EXPECT_GT(glm::length(p), 0.1f) << k;
  for (std::size_t v = 0; v < mesh.layers[10].vertexCount(); ++v) {
    const glm::vec3 step = mesh.layers[10].positions[v] - mesh.layers[9].positions[v];
    EXPECT_LT(step.y, -0.9f * glm::length(step)) << v;
  }
}

TEST(ScriptGrowth, TheSameScriptGivesTheSameBitsForAnyNumberOfThreads) {
  const std::string script =
      kParted +
      "comb all 6 length 0.2\nselect back z < -0.05\nsweep back 5 through 0 0 -0.2 0 -0.1 -0.2\n"
      "smooth all 0.3\n";
  const HairMesh many = meshOf(script);
  const ThreadLimit one(1);
  EXPECT_TRUE(test::identical(many, meshOf(script)));
}

}  // namespace
}  // namespace hair

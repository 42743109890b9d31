#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <tests/hair_mesh/sample_meshes.h>

// Each test breaks one constraint of a valid mesh and reads the sentence.
namespace hair {
namespace {

using ::testing::Test;

// Two layers on 3 x 2 squares; the faces of bundles 0 and 1 are {0 1 2 3} and {3 2 4 5}.
class WhyInvalid : public Test {
 protected:
  HairMesh mesh = test::stack(test::gridScalp(3, 2), 2);

  void expect(std::string_view sentence) {
    EXPECT_EQ(whyInvalid(mesh), sentence);
    try {
      validate(mesh, "style.obj");
      FAIL() << "validate let it pass";
    } catch (const Error& e) {
      EXPECT_EQ(e.what(), "style.obj: " + std::string(sentence));
    }
  }
  // Bundle j's tip goes down by one; vertices stay.
  void shorten(std::uint32_t j) {
    auto& corners = mesh.layers[mesh.lastLayer[j]--].corners;
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c)
      corners[c] = kNoVertex;
  }
};

TEST_F(WhyInvalid, IsEmptyForAValidMesh) {
  EXPECT_EQ(whyInvalid(mesh), "");
}

TEST_F(WhyInvalid, SeesThatThereIsNoScalp) {
  mesh = {};
  expect("no layers: there is no scalp");
}

TEST_F(WhyInvalid, SeesThatThereIsNoFace) {
  mesh = {};
  mesh.layers.resize(1);
  expect("layer 0: the top layer has no face");
}

TEST_F(WhyInvalid, SeesOffsetsThatAreNotOnePerBundle) {
  mesh.firstCorner.push_back(24);
  expect("firstCorner has 8 entries, needs 7: one more than lastLayer");
  mesh.firstCorner.clear();
  expect("firstCorner has 0 entries, needs 7: one more than lastLayer");
}

TEST_F(WhyInvalid, SeesOffsetsThatDoNotBeginAtZero) {
  mesh.firstCorner[0] = 1;
  expect("firstCorner begins with 1");
}

TEST_F(WhyInvalid, SeesAFaceOfTwoSides) {
  mesh.firstCorner[2] = 6;
  expect("bundle 1: corners 4 to 6, needs at least 3 sides");
}

TEST_F(WhyInvalid, SeesOffsetsThatDecrease) {
  mesh.firstCorner[2] = 2;
  expect("bundle 1: corners 4 to 2, needs at least 3 sides");
}

TEST_F(WhyInvalid, SeesArraysOfTheWrongSize) {
  const HairMesh good = mesh;
  mesh.layers[1].corners.pop_back();
  expect("layer 1: corners has 23 entries, needs 24");
  mesh = good;
  mesh.layers[2].pinned.push_back(0);
  expect("layer 2: pinned has 13 entries, needs 12");
  mesh = good;
  mesh.layers[2].below.pop_back();
  expect("layer 2: below has 11 entries, needs 12");
  mesh = good;
  mesh.layers[0].below.assign(12, 0);
  expect("layer 0: below has 12 entries, needs 0");
}

TEST_F(WhyInvalid, SeesAPlaceThatIsNotFinite) {
  mesh.layers[1].positions[5].z = std::numeric_limits<float>::infinity();
  expect("layer 1, vertex 5: its position is not finite");
  mesh.layers[1].positions[5].z = std::numeric_limits<float>::quiet_NaN();
  expect("layer 1, vertex 5: its position is not finite");
}

TEST_F(WhyInvalid, SeesAPinThatIsNeitherInNorOut) {
  mesh.layers[1].pinned[3] = 2;
  expect("layer 1, vertex 3: pinned is 2, not 0 or 1");
}

TEST_F(WhyInvalid, SeesAVertexOnNone) {
  mesh.layers[2].below[7] = 12;
  expect("layer 2, vertex 7: stands on vertex 12 of 12");
}

TEST_F(WhyInvalid, SeesACornerWithoutAVertex) {
  mesh.layers[2].corners[6] = 12;
  expect("layer 2, face of bundle 1: corner 2 is vertex 12 of 12");
}

TEST_F(WhyInvalid, SeesAVertexTwiceInAFace) {
  mesh.layers[0].corners[6] = mesh.layers[0].corners[4];
  expect("layer 0, face of bundle 1: vertex 3 is in it twice");
}

TEST_F(WhyInvalid, SeesATipAboveAllLayers) {
  mesh.lastLayer[4] = 3;
  expect("bundle 4: lastLayer is 3 of 3 layers");
}

TEST_F(WhyInvalid, SeesAFaceWithACornerMissing) {
  mesh.layers[2].corners[9] = kNoVertex;
  expect("layer 2, face of bundle 2: 1 of its 4 corners have no vertex");
}

TEST_F(WhyInvalid, SeesAFaceAboveTheTip) {
  mesh.lastLayer[3] = 1;
  expect("layer 2, face of bundle 3: is there, and lastLayer says that the tip is in layer 1");
}

TEST_F(WhyInvalid, SeesAFaceMissingBelowTheTip) {
  shorten(3);
  mesh.lastLayer[3] = 2;
  expect("layer 2, face of bundle 3: is missing, and lastLayer says that the tip is in layer 2");
}

TEST_F(WhyInvalid, SeesAFaceThatStandsOnNone) {
  std::fill(mesh.layers[1].corners.begin(), mesh.layers[1].corners.begin() + 4, kNoVertex);
  mesh.lastLayer[0] = 0;
  expect("layer 2, face of bundle 0: stands on no face of the layer below");
}

TEST_F(WhyInvalid, SeesATopLayerWithoutAFace) {
  for (std::uint32_t j = 0; j < 6; ++j) shorten(j);
  mesh.layers[2] = {{}, {}, mesh.layers[2].corners, {}};
  expect("layer 2: the top layer has no face");
}

TEST_F(WhyInvalid, SeesAVertexThatStandsOnTwo) {
  // Layer 1 is cut between bundles 0 and 1 at vertex 3, and what stands there is not.
  HairMesh::Layer& layer = mesh.layers[1];
  layer.positions.push_back(layer.positions[3]);
  layer.below.push_back(3);
  layer.pinned.push_back(0);
  layer.corners[4] = 12;
  expect(
      "layer 2, vertex 3: its corner in the face of bundle 1 stands on vertex 12, below says 3 "
      "(one-to-many: a vertex stands on one vertex)");
}

TEST_F(WhyInvalid, SeesBelowThatIsNotWhatCornersSay) {
  mesh.layers[1].below[0] = 5;
  expect(
      "layer 1, vertex 0: its corner in the face of bundle 0 stands on vertex 0, below says 5 "
      "(one-to-many: a vertex stands on one vertex)");
}

TEST_F(WhyInvalid, SeesAVertexOfNoFace) {
  shorten(0);
  expect("layer 2, vertex 0: no face uses it");
}

// Scalps, as what is wrong there is wrong in any layer.
std::string whyScalp(PolygonMesh scalp) {
  HairMesh mesh;
  mesh.firstCorner = scalp.firstCorner;
  mesh.lastLayer.assign(scalp.faceCount(), 0);
  HairMesh::Layer& root = mesh.layers.emplace_back();
  root.positions = scalp.positions;
  root.corners = scalp.corners;
  root.pinned.assign(scalp.positions.size(), 0);
  const std::string why = whyInvalid(mesh);
  EXPECT_EQ(why.empty(), [&] {
    try {
      makeHairMesh(scalp);
      return true;
    } catch (const Error&) {
      return false;
    }
  }());
  return why;
}

PolygonMesh triangles(std::vector<std::uint32_t> corners) {
  PolygonMesh scalp;
  for (std::uint32_t c = 3; c <= corners.size(); c += 3) scalp.firstCorner.push_back(c);
  const std::uint32_t count = *std::max_element(corners.begin(), corners.end()) + 1;
  for (std::uint32_t v = 0; v < count; ++v)
    scalp.positions.emplace_back(0.01f * float(v), 0.01f * float(v * v), 0);
  scalp.corners = std::move(corners);
  return scalp;
}

TEST(WhyInvalidScalp, SeesThreeFacesAtAnEdge) {
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 1, 0, 3, 0, 1, 4})),
            "layer 0, face of bundle 2: edge 0-1 has two faces already (two-manifold)");
}

TEST(WhyInvalidScalp, SeesNeighboursThatFaceOppositeWays) {
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 0, 1, 3})),
            "layer 0, face of bundle 1: a neighbour runs along edge 0-1 the same way (faces are "
            "oriented alike)");
}

TEST(WhyInvalidScalp, SeesAFaceAtAVertexThatIsClosedAround) {
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 4, 5})),
            "layer 0, face of bundle 3: vertex 0 is closed around already (two-manifold)");
}

TEST(WhyInvalidScalp, SeesAVertexClosedAroundWhileAFaceHangsThere) {
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 0, 4, 5, 0, 2, 3, 0, 3, 1})),
            "layer 0, face of bundle 3: it would close around a vertex while other faces hang "
            "there (two-manifold)");
}

TEST(WhyInvalidScalp, SeesFacesThatHangTogetherAtAPoint) {
  EXPECT_EQ(whyScalp(triangles({1, 2, 0, 0, 3, 4})),
            "layer 0, vertex 0: faces around it are not joined edge to edge");
}

TEST(WhyInvalidScalp, LetsAClosedSurfaceAndAFaceAlonePass) {
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2})), "");
  EXPECT_EQ(whyScalp(triangles({0, 1, 2})), "");
}

TEST(WhyInvalidScalp, LetsFacesAroundAVertexComeInAnyOrder) {
  // Six around vertex 0: every other first, so that they hang together at a point for a while.
  EXPECT_EQ(whyScalp(triangles({0, 1, 2, 0, 3, 4, 0, 5, 6, 0, 6, 1, 0, 2, 3, 0, 4, 5})), "");
}

}  // namespace
}  // namespace hair

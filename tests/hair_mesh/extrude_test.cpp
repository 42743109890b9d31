// Small cases whose outcome is known. Laws for all meshes: property_test.cpp.
#include <tests/hair_mesh/small_cases.h>

namespace hair {
namespace {

using test::all;
using test::gridEdge;
using test::gridVertex;
using test::kSize;
using test::Numbers;
using test::refusal;
using test::vertexAt;
using test::vertexCounts;

TEST(FaceExtrude, GrowsALayerAlongTheNormals) {
  HairMesh mesh = makeHairMesh(test::gridScalp(3, 2));
  extrudeFaces(all(mesh), 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{12, 12}));
  EXPECT_EQ(mesh.lastLayer, Numbers(6, 1));
  for (std::uint32_t v = 0; v < 12; ++v) {
    EXPECT_EQ(mesh.layers[1].positions[v],
              mesh.layers[0].positions[mesh.layers[1].below[v]] + glm::vec3(0, 0.03f, 0));
    EXPECT_EQ(mesh.layers[1].pinned[v], 0);
  }
}

TEST(FaceExtrude, MovesABallsVerticesOutward) {
  HairMesh mesh = makeHairMesh(test::ballScalp(2, 0.1f));
  extrudeFaces(all(mesh), 0.05f, mesh);
  for (const glm::vec3& p : mesh.layers[1].positions) EXPECT_NEAR(glm::length(p), 0.15f, 1e-6f);
}

TEST(FaceExtrude, OfFacesThatTouchAtACornerKeepsThemApart) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 3}, 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 8}));
}

TEST(FaceExtrude, JoinsThoseThatStandThereAlreadyWhereTheyStand) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0}, 0.03f, mesh);
  for (glm::vec3& p : mesh.layers[1].positions) p += glm::vec3(0.001f, 0.002f, 0.003f);
  const auto stood = mesh.layers[1].positions;
  extrudeFaces(Numbers{1}, 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 6}));
  for (std::size_t v = 0; v < stood.size(); ++v) EXPECT_EQ(mesh.layers[1].positions[v], stood[v]);
}

TEST(FaceExtrude, JoinsOppositeFacesThatStoodApartAndCoincide) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 3}, 0.03f, mesh);
  extrudeFaces(Numbers{1, 2}, 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 9}));
}

TEST(FaceExtrude, LeavesASlitWhereAVertexWouldBeInTwoPlaces) {
  // Bundle 1 lies between 0 and 3, which have moved apart: it joins 0 and not 3.
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 3}, 0.03f, mesh);
  const std::uint32_t moved = gridVertex(mesh, 1, 3, 1, 1);
  mesh.layers[1].positions[moved].x += 0.005f;
  extrudeFaces(Numbers{1}, 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 10}));
  EXPECT_EQ(connectedFaces(mesh, 1, 1), (Numbers{0, 1}));
  EXPECT_EQ(connectedFaces(mesh, 1, 3), (Numbers{3}));
  EXPECT_EQ(gridVertex(mesh, 1, 1, 1, 1), gridVertex(mesh, 1, 0, 1, 1));
}

TEST(FaceExtrude, JoinsNewFacesAmongThemselvesFirst) {
  // Around the middle: 0 and 1 stand in different places; new are 2, beside 0, and 3, beside 1.
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 1}, 0.03f, mesh);
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  mesh.layers[1].positions[gridVertex(mesh, 1, 1, 1, 1)].x += 0.005f;
  extrudeFaces(Numbers{2, 3}, 0.03f, mesh);
  EXPECT_EQ(connectedFaces(mesh, 1, 0), (Numbers{0, 2, 3}));
}

TEST(FaceExtrude, KeepsApartWhatIsPinnedFromWhatIsNot) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 3}, 0.03f, mesh);
  mesh.layers[1].pinned[gridVertex(mesh, 1, 3, 1, 1)] = 1;
  extrudeFaces(Numbers{1}, 0.03f, mesh);
  EXPECT_EQ(connectedFaces(mesh, 1, 1), (Numbers{0, 1}));
}

TEST(FaceExtrude, AroundACutIsAsIfAllHadBeenThereBefore) {
  HairMesh cutLast = makeHairMesh(test::gridScalp(2, 2)), mesh = cutLast;
  extrudeFaces(all(cutLast), 0.03f, cutLast);
  separateEdges(1, std::vector{gridEdge(cutLast, 1, 0, 1, 0, 1, 1)}, cutLast);
  extrudeFaces(Numbers{0, 1}, 0.03f, mesh);
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  extrudeFaces(Numbers{2, 3}, 0.03f, mesh);
  EXPECT_EQ(test::Unnumbered(mesh), test::Unnumbered(cutLast));
}

TEST(FaceExtrude, DoesNotCloseACut) {
  // A cube: two sides are cut apart along their edge, and one grows at each end of it, joined with
  // both. The first may hold them together at its end, the second would close the cut.
  HairMesh mesh = makeHairMesh(test::ballScalp(1));
  const auto beside = [&](std::uint32_t bundle, std::uint32_t v) {
    const auto face = mesh.face(0, bundle);
    return std::find(face.begin(), face.end(), v) != face.end();
  };
  HairMeshEdge edge;  // of bundles 0 and 2
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = mesh.face(0, 0)[i], b = mesh.face(0, 0)[(i + 1) % 4];
    if (beside(2, a) && beside(2, b)) edge = {a, b};
  }
  Numbers atEnds;
  for (const std::uint32_t end : {edge.a, edge.b})
    for (std::uint32_t j = 0; j < 6; ++j)
      if (j != 0 && j != 2 && beside(j, end)) atEnds.push_back(j);
  ASSERT_EQ(atEnds.size(), 2u);
  const glm::vec3 a = mesh.layers[0].positions[edge.a], b = mesh.layers[0].positions[edge.b];

  extrudeFaces(Numbers{0, 2}, 0.03f, mesh);
  separateEdges(1, std::vector{HairMeshEdge{vertexAt(mesh, 1, 0, a), vertexAt(mesh, 1, 0, b)}},
                mesh);
  extrudeFaces({&atEnds[0], 1}, 0.03f, mesh);
  EXPECT_EQ(vertexAt(mesh, 1, 0, a), vertexAt(mesh, 1, 2, a));
  EXPECT_NE(vertexAt(mesh, 1, 0, b), vertexAt(mesh, 1, 2, b));
  extrudeFaces({&atEnds[1], 1}, 0.03f, mesh);
  EXPECT_EQ(vertexAt(mesh, 1, 0, a), vertexAt(mesh, 1, 2, a));
  EXPECT_NE(vertexAt(mesh, 1, 0, b), vertexAt(mesh, 1, 2, b));
}

TEST(FaceExtrude, TakesTipsOfDifferentLayersAlongTheNormalsTheyHave) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 1));
  extrudeFaces(Numbers{0}, 0.03f, mesh);
  // Bundle 0's tip in layer 1 is tilted; bundle 1's new face there joins it and does not turn it.
  mesh.layers[1].positions[gridVertex(mesh, 1, 0, 0, 0)].y += kSize / 2;
  mesh.layers[1].positions[gridVertex(mesh, 1, 0, 0, 1)].y += kSize / 2;
  extrudeFaces(Numbers{0, 1}, 0.01f, mesh);
  const glm::vec3 tilted = 0.01f * glm::normalize(glm::vec3(1, 2, 0));
  for (std::size_t v = 0; v < 4; ++v) {
    const glm::vec3 step =
        mesh.layers[2].positions[v] - mesh.layers[1].positions[mesh.layers[2].below[v]];
    EXPECT_LT(glm::distance(step, tilted), 1e-7f);
  }
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 6, 4}));
}

TEST(FaceExtrude, RefusesWhatItCannotDo) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 1));
  const auto extrude = [&](Numbers bundles, float distance) {
    return refusal(mesh, [&] { extrudeFaces(bundles, distance, mesh); });
  };
  EXPECT_EQ(extrude({2}, 0.1f), "bundle 2 does not exist: there are 2, numbered from 0");
  EXPECT_EQ(extrude({1, 1}, 0.1f), "bundle 1 is named twice");
  EXPECT_EQ(extrude({}, 0.1f), "no bundles are named");
  EXPECT_EQ(extrude({0}, NAN), "the distance to extrude is not finite");
  for (glm::vec3& p : mesh.layers[0].positions) p.x = 0;
  EXPECT_EQ(extrude({0}, 0.1f),
            "layer 0, vertex 0: the faces around it have no area, so there is no way to extrude "
            "bundle 0; move its vertices apart");
  mesh.layers[0].pinned.pop_back();
  EXPECT_EQ(extrude({0}, 0.1f),
            "hair mesh before the operation: layer 0: pinned has 5 entries, needs 6");
}

TEST(FaceDelete, PartsWhatIsLeftAtAPoint) {
  HairMesh mesh = test::stack(test::gridScalp(2, 2), 2);
  deleteFaces(Numbers{1, 2}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 9, 8}));
  EXPECT_EQ(mesh.lastLayer, (Numbers{2, 1, 1, 2}));
}

TEST(FaceDelete, OfABundleWithoutLengthTakesItsNumber) {
  HairMesh mesh = makeHairMesh(test::gridScalp(3, 1));
  extrudeFaces(Numbers{2}, 0.03f, mesh);
  deleteFaces(Numbers{1}, mesh);
  EXPECT_EQ(mesh.bundleCount(), 2u);
  EXPECT_EQ(mesh.lastLayer, (Numbers{0, 1}));
  EXPECT_EQ(vertexCounts(mesh), (Numbers{8, 4}));
  deleteFaces(Numbers{0, 1}, mesh);
  EXPECT_EQ(mesh.lastLayer, Numbers{0});
  EXPECT_EQ(vertexCounts(mesh), Numbers{4});
}

TEST(FaceDelete, LeavesAFaceOfTheScalp) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 1));
  EXPECT_EQ(refusal(mesh, [&] { deleteFaces(all(mesh), mesh); }),
            "deleting every face would leave no scalp");
}

}  // namespace
}  // namespace hair

// Small cases whose outcome is known. Laws for all meshes: property_test.cpp.
#include <tests/hair_mesh/small_cases.h>

namespace hair {
namespace {

using test::all;
using test::faceOf;
using test::gridEdge;
using test::kSize;
using test::Numbers;
using test::refusal;
using test::vertexCounts;

TEST(LayerInsert, IsHalfWayAndForConnectedFacesOnly) {
  HairMesh mesh = test::stack(test::gridScalp(4, 1), 2, {0, 0.04f, 0});
  separateEdges(1, std::vector{gridEdge(mesh, 1, 1, 2, 0, 2, 1)}, mesh);
  mesh.layers[2].pinned.assign(mesh.layers[2].vertexCount(), 1);
  insertLayer(2, 1, mesh);
  EXPECT_EQ(mesh.lastLayer, (Numbers{3, 3, 2, 2}));
  EXPECT_EQ(vertexCounts(mesh), (Numbers{10, 12, 12, 6}));
  EXPECT_FLOAT_EQ(mesh.layers[2].positions[mesh.face(2, 0)[0]].y, 0.06f);
  EXPECT_FLOAT_EQ(mesh.layers[2].positions[mesh.face(2, 3)[0]].y, 0.08f);
  EXPECT_FLOAT_EQ(mesh.layers[3].positions[mesh.face(3, 0)[0]].y, 0.08f);
  EXPECT_EQ(mesh.layers[2].pinned[mesh.face(2, 0)[0]], 0);
  EXPECT_EQ(mesh.layers[2].pinned[mesh.face(2, 3)[0]], 1);
  EXPECT_EQ(mesh.layers[3].pinned[mesh.face(3, 0)[0]], 1);
}

TEST(LayerInsert, BelowAForkIsParted) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  insertLayer(1, 0, mesh);
  EXPECT_EQ(mesh.lastLayer, (Numbers{2, 1}));
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 8, 4}));
}

TEST(LayerRemove, AtTipsIsFaceDelete) {
  HairMesh mesh = test::stack(test::gridScalp(3, 1), 2), other = mesh;
  removeLayer(2, 1, mesh);
  deleteFaces(all(other), other);
  EXPECT_TRUE(test::identical(mesh, other));
}

TEST(LayerRemove, LetsWhatIsAboveStandOnWhatIsBelow) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 3);
  separateEdges(2, std::vector{gridEdge(mesh, 2, 0, 1, 0, 1, 1)}, mesh);
  removeLayer(2, 1, mesh);
  EXPECT_EQ(mesh.lastLayer, (Numbers{3, 2}));
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 6, 8, 4}));
  EXPECT_FLOAT_EQ(mesh.layers[2].positions[mesh.face(2, 1)[0]].y, 0.09f);
  EXPECT_EQ(refusal(mesh, [&] { removeLayer(3, 1, mesh); }),
            "bundle 1 has no face in layer 3: its tip is in layer 2");
}

TEST(FaceDivide, CutsABundleInAllItsLayers) {
  HairMesh mesh = test::stack(test::mixedScalp(), 2);
  const Numbers was = faceOf(mesh, 2, 0);  // the hexagon
  const auto bundles = static_cast<std::uint32_t>(mesh.bundleCount());
  const Numbers counts = vertexCounts(mesh);
  EXPECT_EQ(divideFace(0, 4, 1, mesh), bundles);
  EXPECT_EQ(faceOf(mesh, 2, 0), (Numbers{was[4], was[5], was[0], was[1]}));
  EXPECT_EQ(faceOf(mesh, 2, bundles), (Numbers{was[1], was[2], was[3], was[4]}));
  EXPECT_EQ(mesh.lastLayer, Numbers(bundles + 1, 2));
  EXPECT_EQ(vertexCounts(mesh), counts);
  const auto divide = [&](std::uint32_t a, std::uint32_t b) {
    return refusal(mesh, [&] { divideFace(0, a, b, mesh); });
  };
  EXPECT_EQ(divide(0, 3),
            "bundle 0: corners 0 and 3 are the same or neighbours, so one part would have no area");
  EXPECT_EQ(divide(1, 1),
            "bundle 0: corners 1 and 1 are the same or neighbours, so one part would have no area");
  EXPECT_EQ(divide(0, 4), "bundle 0 has corners 0 to 3, not 4");
}

TEST(FaceDivide, KeepsTheTipOfTheBundle) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 2);
  deleteFaces(Numbers{1}, mesh);
  EXPECT_EQ(divideFace(1, 0, 2, mesh), 2u);
  EXPECT_EQ(mesh.lastLayer, (Numbers{2, 1, 1}));
}

TEST(FaceDivide, RefusesACutAlongAnEdgeThatIsThere) {
  PolygonMesh scalp;
  scalp.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}};
  test::addFace(scalp, {0, 1, 2, 3});
  test::addFace(scalp, {1, 0, 4});
  test::addFace(scalp, {0, 2, 4});
  test::addFace(scalp, {2, 1, 4});
  HairMesh mesh = makeHairMesh(scalp);
  EXPECT_EQ(
      refusal(mesh, [&] { divideFace(0, 0, 2, mesh); }),
      "hair mesh after the operation: layer 0, face of bundle 4: edge 0-2 has two faces already "
      "(two-manifold)");
}

TEST(EdgeDivide, AddsACornerToBothBundlesAndWhereTheyPartedToEach) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 2);
  separateEdges(2, std::vector{gridEdge(mesh, 2, 0, 1, 0, 1, 1)}, mesh);
  const Numbers was = faceOf(mesh, 1, 0);
  // The edge of bundle 0 that is bundle 1's too.
  std::uint32_t corner = 0;
  while (mesh.layers[0].positions[was[corner]].x != kSize ||
         mesh.layers[0].positions[was[(corner + 1) % 4]].x != kSize)
    ++corner;
  divideEdge(0, corner, mesh);
  EXPECT_EQ(mesh.sides(0), 5u);
  EXPECT_EQ(mesh.sides(1), 5u);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{7, 7, 10}));
  EXPECT_EQ(mesh.face(1, 0)[corner + 1], 6u);
  EXPECT_EQ(mesh.layers[1].positions[6], glm::vec3(kSize, 0.03f, kSize / 2));
  EXPECT_EQ(mesh.layers[2].positions[8], mesh.layers[2].positions[9]);
  EXPECT_EQ(mesh.layers[2].below[8], 6u);
  EXPECT_EQ(mesh.layers[2].below[9], 6u);
}

TEST(EdgeDivide, AtTheScalpsBoundaryChangesOneBundle) {
  HairMesh mesh = test::stack(test::gridScalp(1, 1), 1);
  divideEdge(0, 3, mesh);
  EXPECT_EQ(mesh.sides(0), 5u);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{5, 5}));
  EXPECT_EQ(refusal(mesh, [&] { divideEdge(0, 5, mesh); }), "bundle 0 has corners 0 to 4, not 5");
  EXPECT_EQ(refusal(mesh, [&] { divideEdge(1, 0, mesh); }),
            "bundle 1 does not exist: there are 1, numbered from 0");
}

}  // namespace
}  // namespace hair

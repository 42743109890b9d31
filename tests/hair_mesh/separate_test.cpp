// Small cases whose outcome is known. Laws for all meshes: property_test.cpp.
#include <tests/hair_mesh/small_cases.h>

namespace hair {
namespace {

using test::all;
using test::faceOf;
using test::gridEdge;
using test::gridVertex;
using test::kSize;
using test::Numbers;
using test::refusal;
using test::vertexCounts;

// The paper's figure 2a, in small: hair that forks.
TEST(EdgeSeparate, MakesAForkThatGrowsOnApart) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 1));
  extrudeFaces(all(mesh), 0.03f, mesh);
  extrudeFaces(all(mesh), 0.03f, mesh);
  separateEdges(2, std::vector{gridEdge(mesh, 2, 0, 1, 0, 1, 1)}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 6, 8}));
  // What was keeps its number; what is new comes last, at the same place, on the same vertex.
  EXPECT_EQ(faceOf(mesh, 2, 0), faceOf(mesh, 1, 0));
  for (const std::uint32_t v : {6u, 7u}) {
    const std::uint32_t under = mesh.layers[2].below[v];
    EXPECT_EQ(mesh.layers[2].positions[v],
              mesh.layers[1].positions[under] + glm::vec3(0, 0.03f, 0));
  }
  extrudeFaces(all(mesh), 0.03f, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 6, 8, 8}));
  EXPECT_EQ(connectedFaces(mesh, 3, 0), (Numbers{0}));
  EXPECT_EQ(connectedFaces(mesh, 1, 0), (Numbers{0, 1}));
}

TEST(EdgeSeparate, GoesOnUpwardAndNotDownward) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 3);
  separateEdges(2, std::vector{gridEdge(mesh, 2, 0, 1, 0, 1, 1)}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{6, 6, 8, 8}));
}

TEST(EdgeSeparate, OpensASlitOfTwoEdgesInsideAndNoneOfOne) {
  HairMesh mesh = test::stack(test::gridScalp(4, 2), 1);
  // Along row 1, from (1, 1) by (2, 1) to (3, 1): all three are inside.
  const HairMeshEdge first = gridEdge(mesh, 1, 1, 1, 1, 2, 1);
  const HairMeshEdge second = gridEdge(mesh, 1, 2, 2, 1, 3, 1);
  EXPECT_EQ(refusal(mesh, [&] { separateEdges(1, std::vector{first}, mesh); }),
            text("layer 1: edge ", std::min(first.a, first.b), "-", std::max(first.a, first.b),
                 " would part nothing: at both its ends the faces on its sides stay joined around "
                 "the vertex; cut on from one of them, or along two edges in a row"));
  separateEdges(1, std::vector{first, second}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{15, 16}));
  EXPECT_EQ(connectedFaces(mesh, 1, 0), all(mesh));
}

TEST(EdgeSeparate, PartsABoundaryVertexAlone) {
  HairMesh mesh = test::stack(test::gridScalp(2, 2), 1);
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 10}));
  EXPECT_EQ(gridVertex(mesh, 1, 0, 1, 1), gridVertex(mesh, 1, 1, 1, 1));
}

TEST(EdgeSeparate, RefusesWhatHasNoTwoSides) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  const auto cut = [&](std::size_t layer, std::vector<HairMeshEdge> edges) {
    return refusal(mesh, [&] { separateEdges(layer, edges, mesh); });
  };
  EXPECT_EQ(cut(1, {{0, 1}}),
            "layer 1: edge 0-1 has a face on one side only, there is nothing to separate");
  EXPECT_EQ(cut(1, {{0, 2}}), "layer 1: no edge joins vertices 0 and 2");
  EXPECT_EQ(cut(1, {}), "no edges are named");
  EXPECT_EQ(cut(0, {{2, 3}}), "layer 0 is the scalp's: name a layer from 1 on");
  EXPECT_EQ(cut(2, {{2, 3}}), "layer 2 does not exist: the top layer is 1");
}

TEST(VertexSeparate, GivesEachFaceAVertexOfItsOwn) {
  HairMesh mesh = test::stack(test::gridScalp(2, 2), 2);
  separateVertices(1, Numbers{gridVertex(mesh, 1, 0, 1, 1)}, mesh);
  // Four at the middle; and those in the middle of the sides, where two faces would hang together
  // at a point, are two each.
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 9 + 3 + 4, 9 + 3 + 4}));
  EXPECT_EQ(connectedFaces(mesh, 1, 0), (Numbers{0}));
}

TEST(VertexSeparate, InsideALargerMeshLeavesTheRestJoined) {
  HairMesh mesh = test::stack(test::gridScalp(4, 4), 1);
  separateVertices(1, Numbers{gridVertex(mesh, 1, 5, 2, 2)}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{25, 28}));
  EXPECT_EQ(refusal(mesh, [&] { separateVertices(1, Numbers{0}, mesh); }),
            "layer 1: vertex 0 has one face only, there is nothing to separate");
  EXPECT_EQ(refusal(mesh, [&] { separateVertices(1, Numbers{28}, mesh); }),
            "layer 1: vertex 28 does not exist: there are 28, numbered from 0");
}

TEST(VertexWeld, JoinsHalfWayAndBelowAndNotAbove) {
  HairMesh mesh = test::stack(test::gridScalp(2, 2), 3);
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 10, 10, 10}));
  const std::uint32_t a = gridVertex(mesh, 2, 0, 1, 0), b = gridVertex(mesh, 2, 1, 1, 0);
  mesh.layers[2].positions[a].x -= 0.002f;
  mesh.layers[2].positions[b].x += 0.004f;
  mesh.layers[2].pinned[b] = 1;
  weldVertices(2, a, b, mesh);
  EXPECT_EQ(vertexCounts(mesh), (Numbers{9, 9, 9, 10}));
  const std::uint32_t welded = gridVertex(mesh, 2, 0, 1, 0);
  EXPECT_EQ(welded, gridVertex(mesh, 2, 1, 1, 0));
  EXPECT_FLOAT_EQ(mesh.layers[2].positions[welded].x, kSize + 0.001f);
  EXPECT_EQ(mesh.layers[2].pinned[welded], 1);
}

TEST(VertexWeld, RefusesWhatWouldHangTogetherAtAPoint) {
  HairMesh mesh = makeHairMesh(test::gridScalp(2, 2));
  extrudeFaces(Numbers{0, 3}, 0.03f, mesh);
  const std::uint32_t a = gridVertex(mesh, 1, 0, 1, 1), b = gridVertex(mesh, 1, 3, 1, 1);
  const auto weld = [&](std::uint32_t x, std::uint32_t y) {
    return refusal(mesh, [&] { weldVertices(1, x, y, mesh); });
  };
  EXPECT_EQ(weld(a, b), text("layer 1: vertices ", a, " and ", b,
                             " would hold faces together at a point only; weld an edge that ends "
                             "there"));
  EXPECT_EQ(weld(a, a), text("layer 1: vertex ", a, " is to be welded with itself"));
  const std::uint32_t c = gridVertex(mesh, 1, 3, 2, 2);
  EXPECT_EQ(weld(a, c),
            text("layer 1: vertices ", a, " and ", c, " stand on different vertices of the scalp, ",
                 mesh.layers[1].below[a], " and ", mesh.layers[1].below[c]));
  EXPECT_EQ(weld(a, 8), "layer 1: vertex 8 does not exist: there are 8, numbered from 0");
}

TEST(EdgeWeld, ClosesAFork) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 2);
  const HairMesh whole = mesh;
  separateEdges(1, std::vector{gridEdge(mesh, 1, 0, 1, 0, 1, 1)}, mesh);
  const HairMeshEdge a = gridEdge(mesh, 2, 0, 1, 0, 1, 1), b = gridEdge(mesh, 2, 1, 1, 0, 1, 1);
  weldEdges(2, a, {b.b, b.a}, mesh);
  EXPECT_TRUE(test::identical(mesh, whole));
}

TEST(EdgeWeld, RefusesEdgesOfDifferentPlacesOnTheScalp) {
  HairMesh mesh = test::stack(test::gridScalp(3, 1), 1);
  const HairMeshEdge a = gridEdge(mesh, 1, 0, 1, 0, 1, 1), b = gridEdge(mesh, 1, 1, 2, 0, 2, 1);
  EXPECT_EQ(refusal(mesh, [&] { weldEdges(1, a, b, mesh); }),
            text("layer 1: edges ", a.a, "-", a.b, " and ", b.a, "-", b.b,
                 " do not stand on one edge of the scalp"));
  EXPECT_EQ(refusal(mesh, [&] { weldEdges(1, a, {a.b, a.a}, mesh); }),
            text("layer 1: edge ", a.a, "-", a.b, " is to be welded with itself"));
}

}  // namespace
}  // namespace hair

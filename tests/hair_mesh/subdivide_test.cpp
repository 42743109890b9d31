#include <libhair/geometry/openmesh-inl.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include <algorithm>
#include <set>

#include <tests/hair_mesh/small_cases.h>

namespace hair {
namespace {

using test::all;
using test::Numbers;
using test::refusal;
using test::vertexCounts;

OpenPolyMesh openMeshOf(const HairMesh& mesh, std::size_t layer) {
  OpenPolyMesh surface;
  for (const glm::vec3& p : mesh.layers[layer].positions) surface.add_vertex({p.x, p.y, p.z});
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    std::vector<OpenPolyMesh::VertexHandle> face;
    for (const std::uint32_t v : mesh.face(layer, j)) face.emplace_back(int(v));
    surface.add_face(face);
  }
  return surface;
}

// A face by its vertices alone, in order, the least first.
Numbers turned(Numbers face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// That the layer is `expected`, up to the numbers of vertices.
void expectSame(const HairMesh& mesh, std::size_t layer, const OpenPolyMesh& expected) {
  const auto& positions = mesh.layers[layer].positions;
  ASSERT_EQ(positions.size(), expected.n_vertices());
  Numbers number;  // there, of each vertex here
  for (const glm::vec3& p : positions) {
    std::uint32_t nearest = 0;
    float least = 1;
    for (const auto v : expected.vertices()) {
      const auto& q = expected.point(v);
      const float d = glm::distance(p, glm::vec3(q[0], q[1], q[2]));
      if (d < least) least = d, nearest = static_cast<std::uint32_t>(v.idx());
    }
    EXPECT_LT(least, 1e-7f);
    number.push_back(nearest);
  }
  ASSERT_EQ(std::set(number.begin(), number.end()).size(), number.size());
  std::set<Numbers> here, there;
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j) {
    Numbers face;
    for (const std::uint32_t v : mesh.face(layer, j)) face.push_back(number[v]);
    here.insert(turned(face));
  }
  for (const auto f : expected.faces()) {
    Numbers face;
    for (const auto v : f.vertices_ccw()) face.push_back(static_cast<std::uint32_t>(v.idx()));
    there.insert(turned(face));
  }
  EXPECT_EQ(here, there);
}

// A closed ball, so that rules for boundaries, where OpenMesh has others, play no part; two layers,
// the upper one out of shape.
HairMesh ballWithALayer(const PolygonMesh& scalp) {
  HairMesh mesh = makeHairMesh(scalp);
  extrudeFaces(all(mesh), 0.05f, mesh);
  for (std::size_t v = 0; v < mesh.layers[1].vertexCount(); ++v) {
    glm::vec3& p = mesh.layers[1].positions[v];
    p += 0.01f * glm::vec3(std::sin(7.f * float(v)), std::cos(5.f * float(v)), std::sin(float(v)));
  }
  return mesh;
}

// Each square cut in two.
PolygonMesh triangulated(const PolygonMesh& quads) {
  PolygonMesh scalp;
  scalp.positions = quads.positions;
  for (std::size_t f = 0; f < quads.faceCount(); ++f) {
    const auto q = quads.face(f);
    test::addFace(scalp, {q[0], q[1], q[2]});
    test::addFace(scalp, {q[0], q[2], q[3]});
  }
  return scalp;
}

TEST(Subdivide, CatmullClarkIsOpenMeshs) {
  for (const PolygonMesh& scalp : {test::ballScalp(2), triangulated(test::ballScalp(1))}) {
    HairMesh mesh = ballWithALayer(scalp);
    OpenPolyMesh layers[] = {openMeshOf(mesh, 0), openMeshOf(mesh, 1)};
    subdivide(Subdivision::CatmullClark, true, mesh);
    for (std::size_t k = 0; k < 2; ++k) {
      OpenMesh::Subdivider::Uniform::CatmullClarkT<OpenPolyMesh, float>().operator()(layers[k], 1);
      expectSame(mesh, k, layers[k]);
    }
  }
}

TEST(Subdivide, LoopIsOpenMeshs) {
  HairMesh mesh = ballWithALayer(triangulated(test::ballScalp(2)));
  for (std::size_t k = 0; k < 2; ++k) {
    OpenMesh::TriMesh_ArrayKernelT<> surface;
    for (const glm::vec3& p : mesh.layers[k].positions) surface.add_vertex({p.x, p.y, p.z});
    for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
      const auto f = mesh.face(k, j);
      surface.add_face(OpenMesh::VertexHandle(int(f[0])), OpenMesh::VertexHandle(int(f[1])),
                       OpenMesh::VertexHandle(int(f[2])));
    }
    OpenMesh::Subdivider::Uniform::LoopT<OpenMesh::TriMesh_ArrayKernelT<>, double>().operator()(
        surface, 1);
    OpenPolyMesh expected;
    for (const auto v : surface.vertices()) expected.add_vertex(surface.point(v));
    for (const auto f : surface.faces()) expected.add_face(f.vertices_ccw().to_vector());
    HairMesh fine = mesh;
    subdivide(Subdivision::Loop, true, fine);
    expectSame(fine, k, expected);
  }
}

// The cubic B-spline's knots of 4 control points of a closed square, by hand: corners go to
// 3/4 P + 1/8 of both neighbours, edges to their middles.
TEST(Subdivide, MakesASplineOfABoundary) {
  for (const Subdivision rule : {Subdivision::CatmullClark, Subdivision::Loop}) {
    HairMesh mesh =
        makeHairMesh(rule == Subdivision::Loop ? test::triangleScalp(1, 1) : test::gridScalp(1, 1));
    const HairMesh::Layer coarse = mesh.layers[0];
    subdivide(rule, true, mesh);
    const auto holds = [&](glm::vec3 p) {
      return std::any_of(mesh.layers[0].positions.begin(), mesh.layers[0].positions.end(),
                         [&](glm::vec3 q) { return glm::distance(p, q) < 1e-8f; });
    };
    const float s = test::kSize;
    for (const glm::vec3 corner : coarse.positions) {
      const glm::vec3 x(s - corner.x, corner.y, corner.z), z(corner.x, corner.y, s - corner.z);
      EXPECT_TRUE(holds(0.75f * corner + 0.125f * (x + z)));
      EXPECT_TRUE(holds(0.5f * (corner + x)));
      EXPECT_TRUE(holds(0.5f * (corner + z)));
    }
    EXPECT_EQ(mesh.layers[0].vertexCount(), 9u);
  }
}

TEST(Subdivide, PutsPartsOfABundleWhereItWasInTheOrderOfItsCorners) {
  HairMesh mesh = test::stack(test::mixedScalp(), 2);
  deleteFaces(Numbers{0}, mesh);
  const HairMesh coarse = mesh;
  const Numbers first = subdivide(Subdivision::CatmullClark, false, mesh);
  ASSERT_EQ(first.size(), coarse.bundleCount() + 1);
  EXPECT_EQ(first.back(), mesh.bundleCount());
  for (std::uint32_t j = 0; j < coarse.bundleCount(); ++j) {
    EXPECT_EQ(first[j + 1] - first[j], coarse.sides(j));
    for (std::uint32_t part = first[j]; part < first[j + 1]; ++part) {
      EXPECT_EQ(mesh.lastLayer[part], coarse.lastLayer[j]);
      for (std::size_t k = 0; k <= coarse.lastLayer[j]; ++k)
        EXPECT_EQ(mesh.face(k, part)[0], coarse.face(k, j)[part - first[j]]);
    }
  }
}

TEST(Subdivide, WithoutSmoothingLeavesOldVerticesAndHalvesEdges) {
  HairMesh mesh = test::stack(test::triangleScalp(2, 1), 1);
  mesh.layers[1].pinned[3] = 1;
  const HairMesh coarse = mesh;
  const Numbers first = subdivide(Subdivision::Loop, false, mesh);
  EXPECT_EQ(first, (Numbers{0, 4, 8, 12, 16}));
  // 6 vertices and 9 edges.
  EXPECT_EQ(vertexCounts(mesh), (Numbers{15, 15}));
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t v = 0; v < 15; ++v) {
      EXPECT_EQ(mesh.layers[k].pinned[v], k == 1 && v == 3);
      if (v < 6) {
        EXPECT_EQ(mesh.layers[k].positions[v], coarse.layers[k].positions[v]);
      }
    }
    const auto was = coarse.face(k, 2), middle = mesh.face(k, 11);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = coarse.layers[k].positions;
      EXPECT_EQ(mesh.layers[k].positions[middle[i]], 0.5f * (p[was[i]] + p[was[(i + 1) % 3]]));
    }
  }
}

TEST(Subdivide, KeepsForksAndWhatStandsOnWhat) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 2);
  separateEdges(2, std::vector{test::gridEdge(mesh, 2, 0, 1, 0, 1, 1)}, mesh);
  subdivide(Subdivision::CatmullClark, true, mesh);
  // 6 vertices, 7 edges and 2 faces; 8, 8 and 2 where they are parted.
  EXPECT_EQ(vertexCounts(mesh), (Numbers{15, 15, 18}));
  // Layer 1 is straight above the scalp, whose rule it shares.
  for (std::size_t v = 0; v < 15; ++v)
    EXPECT_LT(
        glm::distance(mesh.layers[1].positions[v],
                      mesh.layers[0].positions[mesh.layers[1].below[v]] + glm::vec3(0, 0.03f, 0)),
        1e-8f);
  EXPECT_EQ(connectedFaces(mesh, 2, 0), (Numbers{0, 1, 2, 3}));
}

TEST(Subdivide, OfLoopRefusesOtherFacesThanTriangles) {
  HairMesh mesh = test::stack(test::mixedScalp(), 1);
  EXPECT_EQ(refusal(mesh, [&] { subdivide(Subdivision::Loop, true, mesh); }),
            "Loop's subdivision needs triangles, and bundle 0 has 6 sides; divide its face, or use "
            "Catmull-Clark");
}

}  // namespace
}  // namespace hair

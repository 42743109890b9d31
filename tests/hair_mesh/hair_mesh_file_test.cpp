#include <bit>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <tests/files/samples.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

// Places that no round decimal is near.
void scatter(HairMesh& mesh) {
  std::uint32_t use = 0;
  for (HairMesh::Layer& layer : mesh.layers)
    for (glm::vec3& p : layer.positions)
      for (int c = 0; c < 3; ++c) p[c] += 0.01f * uniform(7, use++) - 0.005f;
}

void expectSame(const HairMesh& a, const HairMesh& b) {
  EXPECT_EQ(a.firstCorner, b.firstCorner);
  EXPECT_EQ(a.lastLayer, b.lastLayer);
  ASSERT_EQ(a.layerCount(), b.layerCount());
  for (std::size_t k = 0; k < a.layerCount(); ++k) {
    EXPECT_EQ(a.layers[k].below, b.layers[k].below) << k;
    EXPECT_EQ(a.layers[k].corners, b.layers[k].corners) << k;
    EXPECT_EQ(a.layers[k].pinned, b.layers[k].pinned) << k;
    ASSERT_EQ(a.layers[k].vertexCount(), b.layers[k].vertexCount()) << k;
    for (std::size_t v = 0; v < a.layers[k].vertexCount(); ++v)
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(std::bit_cast<std::uint32_t>(a.layers[k].positions[v][c]),
                  std::bit_cast<std::uint32_t>(b.layers[k].positions[v][c]))
            << k << ' ' << v;
  }
}

TEST(HairMeshFile, AStackComesBackBitForBit) {
  HairMesh mesh = test::stack(test::gridScalp(4, 3), 5);
  scatter(mesh);
  mesh.layers[2].positions[3] = {-0.0f, 1e-41f, 16777217.0f};
  expectSame(parseHairMesh(hairMeshBytes(mesh), "a.obj"), mesh);
}

// Two squares on one scalp whose hair has parted in layer 2, one longer than the other.
HairMesh fork() {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  HairMesh::Layer top;
  top.corners = {0, 1, 2, 3, 4, 5, 6, 7};
  top.below = mesh.layers[1].corners;
  for (const std::uint32_t v : top.below)
    top.positions.push_back(mesh.layers[1].positions[v] + glm::vec3(0, 0.03f, 0));
  top.pinned.assign(8, 0);
  mesh.layers.push_back(top);
  top.positions.resize(4);
  top.pinned.resize(4);
  top.below = {0, 1, 2, 3};
  top.corners = {0, 1, 2, 3, kNoVertex, kNoVertex, kNoVertex, kNoVertex};
  mesh.layers.push_back(top);
  mesh.lastLayer = {3, 2};
  return mesh;
}

TEST(HairMeshFile, AForkComesBackWithItsPartedVertices) {
  HairMesh mesh = fork();
  scatter(mesh);
  ASSERT_EQ(whyInvalid(mesh), "");
  expectSame(parseHairMesh(hairMeshBytes(mesh), "a.obj"), mesh);
}

TEST(HairMeshFile, BundlesAreWrittenLongestFirstAndTheOrderIsTold) {
  // Of three squares in a row the middle one ends a layer above the others.
  HairMesh mesh = test::stack(test::gridScalp(3, 1), 1);
  HairMesh::Layer top;
  top.below = {mesh.layers[1].corners.begin() + 4, mesh.layers[1].corners.begin() + 8};
  top.corners.assign(12, kNoVertex);
  for (std::uint32_t i = 0; i < 4; ++i) {
    top.corners[4 + i] = i;
    top.positions.push_back(mesh.layers[1].positions[top.below[i]] + glm::vec3(0, 0.02f, 0));
  }
  top.pinned.assign(4, 0);
  mesh.layers.push_back(top);
  mesh.lastLayer = {1, 2, 1};
  ASSERT_EQ(whyInvalid(mesh), "");

  const TemporaryFolder folder;
  const std::vector<std::uint32_t> order = writeHairMesh(folder / "a.obj", mesh);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{1, 0, 2}));
  const HairMesh read = readHairMesh(folder / "a.obj");
  EXPECT_EQ(read.lastLayer, (std::vector<std::uint32_t>{2, 1, 1}));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::uint32_t k = 0; k <= read.lastLayer[i]; ++k)
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(read.face(k, i)[c], mesh.face(k, order[i])[c]) << i << ' ' << k;
  // What stands in order already is written as it stands.
  expectSame(parseHairMesh(hairMeshBytes(read), "a.obj"), read);
}

constexpr const char* kVertices =
    "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n"
    "v 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\n";

TEST(HairMeshFile, TheCustomsOfModellersAreRead) {
  const std::string vertices = kVertices;
  const HairMesh plain =
      parseHairMesh(vertices + "o layer_0\nf 1 2 3 4\no layer_1\nf 5 6 7 8\n", "a.obj");
  ASSERT_EQ(plain.layerCount(), 2u);
  EXPECT_EQ(plain.layers[0].positions[2], glm::vec3(1, 0, 1));
  EXPECT_EQ(plain.layers[1].positions[2], glm::vec3(1, 1, 1));
  for (const char* layers :
       {// Out of order, but named; other names behind; unused vertices; an empty object.
        "o layer_1.001\nf 5 6 7 8\no camera\no layer_0_Mesh\nv 9 9 9\nf 1 2 3 4\n",
        // No names that say more than the order.
        "mtllib a.mtl\no scalp\ng front\nusemtl m\ns off\nf 1//1 2//1 3 4\no tips\nvn 0 1 0\n"
        "f -4/2 -3/1 -2 8/1/1\n",
        // Groups where there are no objects.
        "g default\ng a\nf 1 2 3 4\ng b\nf 5 6 7 8\n"})
    expectSame(parseHairMesh(vertices + layers, "a.obj"), plain);
}

TEST(HairMeshFile, ErrorsNameFileLineAndCause) {
  const auto error = [](const std::string& layers) {
    return errorOf([&] { parseHairMesh(kVertices + layers, "a.obj"); });
  };
  EXPECT_EQ(error("f 1 2 3 4\n"),
            "a.obj: no object: a hair mesh has one (o layer_0, o layer_1 ...) for each layer");
  EXPECT_EQ(error("o a\nf 1 2 3 4\no b\nf 5 6 7 8\nf 5 8 7\n"),
            "a.obj: line 13: b: more faces than the layer below has (1)");
  EXPECT_EQ(error("o a\nf 1 2 3 4\no b\nf 5 6 7\n"),
            "a.obj: line 12: b: face 1 of the object has 3 corners, its root (line 10) has 4");
  EXPECT_EQ(error("v 0 0 2\nv 1 0 2\no a\nf 1 2 3 4\nf 2 9 10 3\n"
                  "o b\nf 5 6 7 8\nv 0 1 3\nv 1 1 3\nf 6 11 12 8\n"),
            "a.obj: line 18: b: vertex 8 stands on two vertices of the layer below");
  EXPECT_EQ(error("o a\nf 1 2 3 4\no b\nf 5 6 7 4\n"),
            "a.obj: line 12: face: vertex 4 is one of another layer, a");
  EXPECT_EQ(error("o layer_1\nf 1 2 3 4\no layer_1.001\nf 5 6 7 8\n"),
            "a.obj: line 12: two objects are layer 1: layer_1 and layer_1.001");
  EXPECT_EQ(error("o a\nf 1 2 3 9\n"),
            "a.obj: line 10: face: vertex 9 does not exist (8 vertices so far)");
  EXPECT_EQ(error("o a\nf 1 2\n"), "a.obj: line 10: face: 2 corners, needs at least 3");
  EXPECT_EQ(error("v 0 nan 0\n"), "a.obj: line 9: vertex: 'nan' is no finite number");
  EXPECT_EQ(error("v 0 inf 0\n"), "a.obj: line 9: vertex: 'inf' is no finite number");
  EXPECT_NE(error("v 0 1e8 0\n").find("a.obj: line 9: vertex: "), std::string::npos);
  EXPECT_NE(error("o a\n").find("without any face"), std::string::npos);
  EXPECT_NE(errorOf([] { readHairMesh("/no/such.obj"); }).find("/no/such.obj"), std::string::npos);
}

TEST(HairMeshFile, WhatIsNoSurfaceIsRefusedWithItsLayerAndBundle) {
  const auto error = [](const std::string& layers) {
    return errorOf([&] { parseHairMesh(kVertices + layers, "a.obj"); });
  };
  for (const char* layers : {"o a\nf 1 2 3\nf 1 2 4\nf 2 1 5\n",  // three on an edge
                             "o a\nf 1 2 3\nf 1 2 4\n",           // one turned over
                             "o a\nf 1 2 3 2\n",                  // a vertex twice
                             "o a\nf 1 2 3\nf 1 5 6\n"}) {        // a vertex holds two alone
    const std::string message = error(layers);
    EXPECT_TRUE(message.starts_with("a.obj: layer 0")) << layers << message;
  }
}

TEST(HairMeshFile, ManyEmptyLayersOnManyRootsCostNoMoreThanTheFile) {
  std::string bytes = "o root\n";
  constexpr int kRoots = 2000;
  for (int i = 0; i < 2 * kRoots + 2; ++i) bytes += text("v ", i / 2, " 0 ", i % 2, '\n');
  for (int i = 0; i < kRoots; ++i)
    bytes += text("f ", 2 * i + 1, ' ', 2 * i + 2, ' ', 2 * i + 4, ' ', 2 * i + 3, '\n');
  for (int k = 1; k < 2000; ++k) bytes += "o\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\nf -4 -3 -2 -1\n";
  const std::string error = errorOf([&] { parseHairMesh(bytes, "a.obj"); });
  EXPECT_NE(error.find("a.obj: 2000 layers on 8000 corners"), std::string::npos) << error;
}

TEST(HairMeshFile, WhatCannotBeReadIsNotWritten) {
  HairMesh mesh = test::stack(test::gridScalp(1, 1), 1);
  mesh.layers[1].positions[2].y = 2e8f;
  const TemporaryFolder folder;
  EXPECT_NE(errorOf([&] { writeHairMesh(folder / "a.obj", mesh); }).find("layer 1"),
            std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(HairMeshFile, PolygonsOfAScalpKeepTheirSides) {
  const PolygonMesh scalp = parsePolygons(sampleObj(), "a.obj");
  ASSERT_EQ(scalp.faceCount(), 2u);
  EXPECT_EQ(scalp.face(0).size(), 4u);
  EXPECT_EQ(scalp.face(1).size(), 3u);
  EXPECT_EQ(scalp.positions.size(), 5u);
  EXPECT_EQ(makeHairMesh(scalp).bundleCount(), 2u);
}

}  // namespace
}  // namespace hair

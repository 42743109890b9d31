#include <gtest/gtest.h>

#include <libhair/files/obj.h>

#include "samples.h"

namespace hair {
namespace {

// Twice the area, summed over all triangles.
float doubleArea(const TriangleMesh& mesh) {
  float sum = 0;
  for (glm::uvec3 t : mesh.triangles)
    sum += glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                  mesh.positions[t.z] - mesh.positions[t.x]));
  return sum;
}

TEST(Obj, PolygonsBecomeTrianglesOfTheSameAreaAndSide) {
  ObjReport report;
  const TriangleMesh mesh = parseObj(sampleObj(), "a.obj", &report);
  EXPECT_EQ(report.faces, 2u);
  EXPECT_EQ(report.split + report.dropped, 0u);
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[4], glm::vec3(2, 0.5f, 0));  // the file's order
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_FLOAT_EQ(doubleArea(mesh), 2.0f + 1.0f);
  for (glm::vec3 n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(Obj, FacesOnAComplexEdgeAreKeptOnVerticesOfTheirOwn) {
  // Three triangles on one edge, like the pages of a book.
  ObjReport report;
  const TriangleMesh mesh =
      parseObj("v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n", "a.obj",
               &report);
  EXPECT_EQ(report.split, 1u);
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.positions.size(), 5u + 3u);
  EXPECT_FLOAT_EQ(doubleArea(mesh), 3.0f);
  for (std::size_t v = 5; v < 8; ++v) EXPECT_EQ(mesh.normals[v], glm::vec3(1, 0, 0));
}

TEST(Obj, FacesWithoutThreeCornersAreDroppedAndCounted) {
  ObjReport report;
  const TriangleMesh mesh =
      parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\nf 1 2 2 3 1\nf 3 3 3\n", "a.obj", &report);
  EXPECT_EQ(report.faces, 3u);
  EXPECT_EQ(report.dropped, 2u);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Obj, ErrorsNameFileLineAndCause) {
  const auto error = [](const std::string& bytes) {
    return errorOf([&] { parseObj(bytes, "a.obj"); });
  };
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(error(three + "f 1 2 4\n"),
            "a.obj: line 4: face: vertex 4 does not exist (3 vertices so far)");
  EXPECT_EQ(error(three + "f 1 2 -4\n"),
            "a.obj: line 4: face: vertex -4 does not exist (3 vertices so far)");
  EXPECT_EQ(error(three + "f 0 1 2\n"),
            "a.obj: line 4: face: vertex 0 does not exist (3 vertices so far)");
  EXPECT_EQ(error(three + "f 1 2\n"), "a.obj: line 4: face: 2 corners, needs at least 3");
  EXPECT_EQ(error(three + "f 1 2 x\n"), "a.obj: line 4: face: 'x' is no whole number");
  EXPECT_EQ(error("v 0 0\n"), "a.obj: line 1: vertex: a number is missing at the end of the line");
  EXPECT_EQ(error("v 0 0 inf\n"), "a.obj: line 1: vertex: 'inf' is no finite number");
  EXPECT_NE(error("v 0 0 1e9\n").find("check the scale"), std::string::npos);
  EXPECT_NE(error("hello\n").find("without any vertex"), std::string::npos);
  EXPECT_NE(error(three).find("without any face"), std::string::npos);
}

}  // namespace
}  // namespace hair

// Strands as edges and lines of meshes.
#include <gtest/gtest.h>

#include <libhair/files/edges.h>
#include <libhair/files/obj_strands.h>
#include <libhair/files/ply_file.h>

#include "samples.h"

namespace hair {
namespace {

using Offsets = std::vector<std::uint32_t>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

TEST(Edges, ChainsGoTheWayTheirEdgesGo) {
  // 4 <- 3 <- 5, and 1 - 0 - 2 whose edges do not agree; 6 stands alone.
  const EdgeChains chains = chainEdges(Edges{{5, 3}, {3, 4}, {0, 1}, {0, 2}}, 7, {}, "a");
  EXPECT_EQ(chains.vertices, (Offsets{1, 0, 2, 5, 3, 4, 6}));
  EXPECT_EQ(chains.first, (Offsets{0, 3, 6, 7}));
  std::vector<bool> keep(7);
  EXPECT_EQ(chainEdges(Edges{{1, 2}}, 7, keep, "a").vertices, (Offsets{1, 2}));
}

TEST(Edges, BranchesAndRingsAreNoStrands) {
  const auto error = [](const Edges& edges) {
    return errorOf([&] { chainEdges(edges, 5, {}, "a.ply"); });
  };
  EXPECT_NE(error({{0, 1}, {0, 2}, {0, 3}}).find("a.ply: vertex 0 (from 0) has more than two"),
            std::string::npos);
  for (const Edges& ring : {Edges{{0, 1}, {1, 2}, {2, 0}}, Edges{{1, 1}}, Edges{{0, 1}, {1, 0}}})
    EXPECT_NE(error(ring).find("closed ring"), std::string::npos);
}

TEST(PlyFile, TextWithOtherElementsAndTypesIsRead) {
  const StrandFile file = parsePly(samplePlyText(), "a.ply");
  EXPECT_EQ(file.strands.first, (Offsets{0, 3, 4}));
  EXPECT_EQ(file.strands.points,
            (std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, {0, 2, 0.5f}, {7, 8, 9}}));
  EXPECT_EQ(file.colours[2], glm::vec3(1, 0, 51 / 255.0f));
  EXPECT_EQ(file.scale, 1.0f);
  EXPECT_EQ(file.thickness, (std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f}));
}

TEST(PlyFile, OfAnIntegerColourTheLargestNumberOfItsTypeIsFullLight) {
  const auto with = [](const std::string& type, const std::string& red) {
    std::string bytes = samplePlyText();
    bytes.replace(bytes.find("uchar red"), 5, type);
    return bytes.replace(bytes.find("255"), 3, red);
  };
  for (const auto& [type, most] : {std::pair{"uchar", 255ll},
                                   {"ushort", 65535ll},
                                   {"uint", 4294967295ll},
                                   {"char", 127ll},
                                   {"short", 32767ll},
                                   {"int", 2147483647ll}}) {
    SCOPED_TRACE(type);
    // The other vertices' 255 does not fit the smallest type.
    const auto parse = [&, name = std::string(type)](long long red) {
      std::string bytes = with(name, std::to_string(red));
      while (name == "char" && bytes.find(" 255 ") != std::string::npos)
        bytes.replace(bytes.find(" 255 "), 5, " 0 ");
      return parsePly(bytes, "a.ply");
    };
    EXPECT_EQ(parse(most).colours[0].x, 1.0f);
    EXPECT_EQ(parse(most / 5).colours[0].x,
              static_cast<float>(static_cast<double>(most / 5) / static_cast<double>(most)));
    EXPECT_NE(errorOf([&] { parse(most + 1); }).find("is not in"), std::string::npos);
    const std::string below = errorOf([&] { parse(-1); });
    EXPECT_NE(below.find(type[0] == 'u' ? "-1 is not in 0 to" : "is -1, below 0"),
              std::string::npos)
        << below;
  }
  // Floats are as they are.
  EXPECT_EQ(parsePly(with("float", "300"), "a.ply").colours[0].x, 300.0f);
}

TEST(PlyFile, ErrorsNameFilePlaceAndCause) {
  const std::string good = samplePlyText();
  const auto error = [&](const char* from, const char* to) {
    std::string bytes = good;
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    bytes.replace(at, std::strlen(from), to);
    return errorOf([&] { parsePly(bytes, "a.ply"); });
  };
  EXPECT_NE(error("ply", "plz").find("a.ply: line 1: 'ply' expected"), std::string::npos);
  EXPECT_NE(error("ascii", "binary_pdp_endian").find("ascii, binary_little_endian and"),
            std::string::npos);
  EXPECT_NE(error("element edge 2", "element face 2").find("it is a mesh, not strands"),
            std::string::npos);
  EXPECT_NE(error("element edge 2", "element rim 2").find("4 points without edges"),
            std::string::npos);
  EXPECT_NE(error("vertex 4", "vertex 0").find("holds no vertices"), std::string::npos);
  EXPECT_NE(error("vertex 4", "vertex 4000000000").find("4000000000 are announced"),
            std::string::npos);
  EXPECT_NE(error("float x", "float w").find("x, y and z"), std::string::npos);
  EXPECT_NE(error("7 8 9", "7 nan 9").find("'nan' is no finite number"), std::string::npos);
  EXPECT_NE(error("\n1 0", "\n1 9").find("vertex 9 does not exist"), std::string::npos);
}

TEST(ObjStrands, LinesContinueCountBackwardsAndShareVertices) {
  const StrandFile file = parseObjStrands(
      "o hair\nv 0 0 0\nv 0 1 0\nv 0 2 \\\n 0\nvt 0 0\nl 1/1 2 \\\n\\\n 3 # tip\nv 5 5 5\n"
      "l -1 -2 1\nf 1 2 3\np 4\n",
      "a.obj");
  EXPECT_EQ(file.strands.first, (Offsets{0, 3, 6, 7}));
  EXPECT_EQ(file.strands.points,
            (std::vector<glm::vec3>{
                {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {5, 5, 5}, {0, 2, 0}, {0, 0, 0}, {5, 5, 5}}));
}

TEST(ObjStrands, AFileOfEdgesIsFollowed) {
  const StrandFile file = parseObjStrands(
      "v 0 0 0\nv 0 1 0\nv 0 2 0\nv 1 0 0\nv 1 1 0\nl 2 3\nl 4 5\nl 1 2\n", "a.obj");
  EXPECT_EQ(file.strands.first, (Offsets{0, 3, 5}));
  EXPECT_EQ(file.strands.points[2], glm::vec3(0, 2, 0));
}

TEST(ObjStrands, ErrorsNameFileLineAndCause) {
  const auto error = [](const char* bytes) {
    return errorOf([&] { parseObjStrands(bytes, "a.obj"); });
  };
  EXPECT_NE(error("v 0 0 0\nl 1 2\n").find("a.obj: line 2: line: vertex 2 does not exist"),
            std::string::npos);
  EXPECT_NE(error("v 0 0 0\nl 1\n").find("1 corners, needs at least 2"), std::string::npos);
  EXPECT_NE(error(sampleObj().c_str()).find("it holds a mesh, not strands"), std::string::npos);
  EXPECT_NE(error("v 0 0\\\n").find("a number is missing"), std::string::npos);
}

}  // namespace
}  // namespace hair

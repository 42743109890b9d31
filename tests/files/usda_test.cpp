// USD text: what it looks like, and what of other people's is read.
#include <sstream>

#include <gtest/gtest.h>

#include <libhair/files/usda/usda_file.h>
#include <libhair/files/usda/usda_write.h>

#include "samples.h"

namespace hair {
namespace {

StrandFile read(const std::string& bytes, std::size_t frame = 0) {
  std::istringstream stream(bytes);
  UsdaReader reader(stream, "a.usda");
  StrandFile file;
  reader.read(frame, file);
  return file;
}

TEST(Usda, IsWrittenAsTheSchemaSays) {
  StrandFile file;
  file.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.1f, -0.0f}});
  file.strands.append(std::vector<glm::vec3>{{1, 0, 0}, {1, -2e-20f, 0}, {1, 99999992, 0}});
  file.defaultThickness = 0.5f;
  file.colours.assign(5, {0.25f, 0.5f, 1});
  std::ostringstream out;
  writeUsda(out, file);
  EXPECT_EQ(out.str(),
            "#usda 1.0\n(\n    defaultPrim = \"Hair\"\n    doc = \"Strands of hair, root to tip\"\n"
            "    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\ndef BasisCurves \"Hair\"\n{\n"
            "    uniform token type = \"linear\"\n    uniform token wrap = \"nonperiodic\"\n"
            "    int[] curveVertexCounts = [2, 3]\n    float[] widths = [0.5] (\n"
            "        interpolation = \"constant\"\n    )\n"
            "    color3f[] primvars:displayColor = [(0.25, 0.5, 1), (0.25, 0.5, 1), (0.25, 0.5, "
            "1), (0.25, 0.5, 1), (0.25, 0.5, 1)] (\n        interpolation = \"vertex\"\n    )\n"
            "    point3f[] points = [(0, 0, 0), (0, 0.1, -0), (1, 0, 0), (1, -2e-20, 0), (1, "
            "99999992, 0)]\n"
            "    float3[] extent = [(-0.25, -0.25, -0.25), (1.25, 99999992, 0.25)]\n}\n");
}

TEST(Usda, WhatSomebodyElseWroteIsRead) {
  std::istringstream stream(sampleUsda());
  UsdaReader reader(stream, "a.usda");
  ASSERT_EQ(reader.frameCount(), 2u);
  EXPECT_EQ(reader.seconds(0), 0);
  EXPECT_EQ(reader.seconds(1), 1.5 / 25);
  StrandFile file;
  reader.read(1, file);
  EXPECT_EQ(file.strands.first, (std::vector<std::uint32_t>{0, 2, 5}));
  EXPECT_EQ(file.strands.points[4], glm::vec3(1, 2, -2));
  EXPECT_EQ(file.thickness, (std::vector<float>{3, 3, 4, 4, 4}));
  reader.read(0, file);  // back again
  EXPECT_EQ(file.strands.points[4], glm::vec3(1, 0, 2));
  EXPECT_EQ(file.thickness, (std::vector<float>{1, 1, 2, 2, 2}));
  EXPECT_TRUE(file.colours.empty());
  EXPECT_EQ(file.defaultColour, glm::vec3(0.5f, 0.25f, 1));
  EXPECT_EQ(file.scale, 0.01f);
  EXPECT_EQ(file.up, UpAxis::ZBack);
}

TEST(Usda, UnitsOfTheFileAreHonouredAndFallBackToCentimetres) {
  const TemporaryFolder folder;
  const StrandFile file = readStrands(folder.write("a.usda", sampleUsda()));
  EXPECT_EQ(file.strands.points[4], 0.01f * glm::vec3(1, 2, 0));
  EXPECT_EQ(file.thickness[4], 0.02f);
  std::string silent = sampleUsda();
  silent.erase(silent.find("(\n"), silent.find(")\n") + 2 - silent.find("(\n"));
  const StrandFile fallback = readStrands(folder.write("b.usda", silent));
  EXPECT_EQ(fallback.scale, 0.01f);
  EXPECT_EQ(fallback.up, UpAxis::Y);
}

TEST(Usda, PlacesBeyondOneBlockAreFound) {
  // Longer than any block, with a string and a comment of brackets across its end.
  std::string bytes = sampleUsda();
  const std::string filler = "    float[] other = [" + std::string(70000, ' ') + "1]\n" +
                             "    string[] s = [\"" + std::string(60000, ']') + "\"]\n    # " +
                             std::string(9000, '}') + '\n';
  bytes.insert(bytes.find("    point3f[]"), filler);
  EXPECT_EQ(read(bytes, 1).strands.points, read(sampleUsda(), 1).strands.points);
  EXPECT_EQ(read(bytes, 0).thickness, read(sampleUsda(), 0).thickness);
}

TEST(Usda, ErrorsNameFileLineAndCause) {
  const auto error = [](const char* from, const char* to) {
    std::string bytes = sampleUsda();
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    bytes.replace(at, std::strlen(from), to);
    return errorOf([&] { read(bytes, 1); });
  };
  const auto says = [](const std::string& message, const char* words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says(error("#usda 1.0", "PXR-USDC"), "a.usda: line 1: this is a binary USD file; turn it into");
  says(error("#usda 1.0", "hello"), "'#usda 1.0' expected");
  says(error("\"linear\"", "\"conic\""), "of type 'conic'; linear and cubic curves are read");
  says(error("\"linear\"", "\"cubic\"; token basis = \"power\""), "has the basis 'power'");
  says(error("# straight", "; uniform token wrap = \"spiral\""), "has the wrap 'spiral'");
  says(error("BasisCurves", "NurbsCurves"), "ends without a BasisCurves");
  says(error("int[] curveVertexCounts", "int[] counts"), "has no curveVertexCounts");
  says(error("point3f[] points", "point3f[] velocities"), "has no points");
  says(error("[2, 3,]", "[2, 4]"), "ask for 6 points, there are 5");
  says(error("[2, 3,]", "[2, -3]"), "curve 1 has -3 points");
  says(error("[2, 3,]", "[2, 9999999999]"), "curve 1 has 9999999999 points");
  says(error("[3, 4]", "[3, 4, 5]"), "widths: 3 values for 2 curves");
  says(error("\"uniform\"", "\"faceVarying\""), "interpolation 'faceVarying' does not fit");
  says(error("2e0", "inf"), "a.usda: line 29: points: 'inf' is no finite number");
  says(error("= 0.01", "= 0"), "metersPerUnit of 0");
  says(error("\"Z\"", "\"X\""), "upAxis 'X'");
  says(error("# straight", "; int[] primvars:displayColor:indices = [1]"),
       "displayColor: index 1 of 1 values");
  says(error("note'''\n  }\n}", "note'''\n  }\n"), "ends within a prim (truncated)");
  says(error("note'''", "note''"), "ends within a string");
}

}  // namespace
}  // namespace hair

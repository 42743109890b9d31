// Curves of pbrt's scenes. Expected points come from de Casteljau's mixing, and from quarter turns.
#include <sstream>

#include <gtest/gtest.h>

#include <libhair/files/pbrt_file.h>

#include "samples.h"

namespace hair {
namespace {

std::string numbers(const std::vector<glm::vec3>& points) {
  std::ostringstream out;
  out.precision(9);
  for (const glm::vec3& p : points) out << p.x << ' ' << p.y << ' ' << p.z << "  ";
  return out.str();
}

std::string curve(const std::vector<glm::vec3>& points, const std::string& more = "") {
  return text("Shape \"curve\" \"string type\" [ \"cylinder\" ] \"point3 P\" [ ", numbers(points),
              "] ", more, '\n');
}

// A Bezier curve of any degree.
glm::vec3 at(std::vector<glm::vec3> p, float t) {
  for (std::size_t left = p.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) p[i] = glm::mix(p[i], p[i + 1], t);
  return p[0];
}

const std::vector<glm::vec3> kFour = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 2, 1}};

StrandFile read(const std::string& bytes) {
  return parsePbrt(bytes, "a.pbrt");
}

void expectCurve(const std::string& bytes, const std::vector<glm::vec3>& bezier) {
  SCOPED_TRACE(bytes);
  const StrandFile file = read(bytes);
  ASSERT_EQ(file.strands.strandCount(), 1u);
  ASSERT_EQ(file.strands.pointCount(), 9u);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_LT(glm::distance(file.strands.points[i], at(bezier, static_cast<float>(i) / 8)), 2e-6f);
}

TEST(Pbrt, CurvesOfBothBasesAndDegrees) {
  expectCurve(curve(kFour), kFour);
  expectCurve(curve(kFour, "\"string basis\" \"bezier\" \"integer degree\" 3"), kFour);
  expectCurve(curve({kFour[0], kFour[1], kFour[2]}, "\"integer degree\" [ 2 ]"),
              {kFour[0], kFour[1], kFour[2]});
  const auto third = [](glm::vec3 a, glm::vec3 b) { return (2.0f * a + b) / 3.0f; };
  const glm::vec3 c1 = third(kFour[1], kFour[2]), c2 = third(kFour[2], kFour[1]);
  expectCurve(
      curve(kFour, "\"string basis\" [ \"bspline\" ]"),
      {0.5f * (third(kFour[1], kFour[0]) + c1), c1, c2, 0.5f * (c2 + third(kFour[2], kFour[3]))});
  expectCurve(
      curve({kFour[0], kFour[1], kFour[2]}, "\"string basis\" \"bspline\" \"integer degree\" 2"),
      {0.5f * (kFour[0] + kFour[1]), kFour[1], 0.5f * (kFour[1] + kFour[2])});
}

TEST(Pbrt, CurvesThatContinueAreOneStrand) {
  const auto moved = [](glm::vec3 by) {
    std::vector<glm::vec3> points = kFour;
    for (glm::vec3& p : points) p += by;
    return points;
  };
  const glm::vec3 step = kFour[3];
  const StrandFile file = read(curve(kFour, "\"float width0\" 3 \"float width1\" [2]") +
                               curve(moved(step), "\"float width0\" 2 \"float width1\" 1") +
                               curve(moved({9, 0, 0})) + "AttributeBegin # a new hair\n" +
                               curve(moved({20, 0, 0}), "\"float width\" 4") + "AttributeEnd\n");
  EXPECT_EQ(file.strands.first, (std::vector<std::uint32_t>{0, 9, 18, 27}));
  EXPECT_LT(glm::distance(file.strands.points[4], step), 1e-6f);
  EXPECT_LT(glm::distance(file.strands.points[8], 2.0f * step), 1e-5f);
  EXPECT_FLOAT_EQ(file.thickness[0], 3);
  EXPECT_FLOAT_EQ(file.thickness[2], 2.5f);
  EXPECT_FLOAT_EQ(file.thickness[8], 1);
  EXPECT_FLOAT_EQ(file.thickness[9], 1);  // pbrt's fallback
  EXPECT_FLOAT_EQ(file.thickness[26], 4);
  EXPECT_TRUE(read(curve(kFour)).thickness.empty());
}

TEST(Pbrt, TransformsGoFromTheLastToTheFirst) {
  const auto first = [](const std::string& words) {
    return read(words + curve({{1, 2, 3}, {2, 2, 3}, {3, 2, 3}, {4, 2, 3}})).strands.points[0];
  };
  const auto expect = [&](const std::string& words, glm::vec3 p) {
    EXPECT_LT(glm::distance(first(words), p), 1e-5f) << words;
  };
  expect("Translate 1 0 0\n", {2, 2, 3});
  expect("Translate 1 0 0 Scale 2 2 2\n", {3, 4, 6});
  expect("Scale 2 2 2 Translate 1 0 0\n", {4, 4, 6});
  expect("Rotate 90 0 0 1\n", {-2, 1, 3});
  expect("Translate 5 0 0 Rotate 90 0 0 3\n", {3, 1, 3});
  expect("Transform [ 0 1 0 0  -1 0 0 0  0 0 1 0  5 6 7 1 ]\n", {3, 7, 10});
  expect("Scale 2 2 2 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1]\n", {12, 4, 6});
  expect("Scale 9 9 9 Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]\n", {1, 2, 3});
  expect("LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 38.5\nWorldBegin\n",
         {1, 2, 3});
  expect("AttributeBegin Translate 9 9 9 AttributeEnd\n", {1, 2, 3});
  expect("Translate 1 0 0 TransformBegin Identity TransformEnd\n", {2, 2, 3});
  const StrandFile wide = read(text("Scale 3 3 3\n", curve(kFour, "\"float width\" 2")));
  EXPECT_FLOAT_EQ(wide.thickness[0], 6);
}

TEST(Pbrt, AllElseIsSkipped) {
  const StrandFile file = read(
      "# Shape \"curve\"\nFilm \"image\" \"integer xresolution\" [ 100 ]\nMaterial \"hair\" \"bool "
      "remap\" true \"rgb sigma\" [ 1 2 3 ]\nShape \"sphere\" \"float radius\" 3\nShape "
      "\"trianglemesh\" \"point P\" [ 1 2 3 ] \"integer indices\" [ 0 0 0 ]\n" +
      curve(kFour));
  EXPECT_EQ(file.strands.strandCount(), 1u);
  const TemporaryFolder folder;
  EXPECT_EQ(
      readStrands(folder.write("a.pbrt", curve(kFour)), {0.01f, UpAxis::ZBack}).strands.points[8],
      0.01f * glm::vec3(3, 1, -2));
}

TEST(Pbrt, DamageIsAnError) {
  const auto says = [](const std::string& bytes, const char* words) {
    const std::string message = errorOf([&] { read(bytes); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with("a.pbrt: line ")) << message;
  };
  says("WorldBegin\n", "without any Shape \"curve\"");
  says("Include \"hair.pbrt\"\n", "read those");
  says(text("\n", curve({kFour[0], kFour[1], kFour[2]})), "line 3: a curve with 9 numbers");
  says(curve(kFour, "\"integer degree\" 4"), "degree 4");
  says(curve(kFour, "\"string basis\" \"hermite\""), "basis 'hermite'");
  says("Shape \"curve\" \"point P\" [ 1 2 x", "'x' is no number");
  says("Shape \"curve\" \"point P\" [ 1 2 3", "is no number");
  says("Shape \"sphere\" \"float radius\" [ 1 2 3", "ends within brackets");
  says("Shape \"cur\n", "does not end in its line");
  says("AttributeEnd\n", "ends nothing");
  says(text("Scale 1e29 1 1 Scale 1e29 1 1\n", curve(kFour)), "beyond all numbers");
}

}  // namespace
}  // namespace hair

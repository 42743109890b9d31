// Curves of USD as other programs write them: in transforms, cubic, several, in variants. What is
// expected is written down again here: curves by repeated mixing, transforms one after the other.
#include <sstream>

#include <gtest/gtest.h>

#include <libhair/files/usda/usda_file.h>

#include "samples.h"

namespace hair {
namespace {

StrandFile readText(const std::string& bytes, std::string_view prim = {}, std::size_t frame = 0) {
  std::istringstream stream(bytes);
  UsdaReader reader(stream, "a.usda", prim);
  StrandFile file;
  reader.read(frame, file);
  return file;
}

std::size_t framesOf(const std::string& bytes) {
  std::istringstream stream(bytes);
  return UsdaReader(stream, "a.usda").frameCount();
}

std::string vectors(const std::vector<glm::vec3>& points) {
  std::ostringstream out;
  out.precision(9);
  for (const glm::vec3& p : points)
    out << (out.tellp() > 0 ? ", (" : "(") << p.x << ", " << p.y << ", " << p.z << ')';
  return '[' + out.str() + ']';
}

std::string curves(const std::string& kind, const std::string& counts,
                   const std::vector<glm::vec3>& points, const std::string& name = "Hair") {
  return "def BasisCurves \"" + name + "\" {\n" + kind + "\nint[] curveVertexCounts = [" + counts +
         "]\npoint3f[] points = " + vectors(points) + "\n";
}

const std::string kLinear = "uniform token type = \"linear\"";

std::string cubic(const std::string& basis, const std::string& wrap) {
  return "uniform token type = \"cubic\"\nuniform token basis = \"" + basis +
         "\"\nuniform token wrap = \"" + wrap + '"';
}

std::vector<glm::vec3> someVertices(std::size_t count) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<float>(i);
    points.emplace_back(std::sin(k), 0.3f * k, std::cos(2 * k));
  }
  return points;
}

const std::string kHead = "#usda 1.0\n(\n metersPerUnit = 1\n upAxis = \"Y\"\n)\n";

void expectNear(const std::vector<glm::vec3>& found, const std::vector<glm::vec3>& expected,
                const std::string& of) {
  SCOPED_TRACE(of);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LT(glm::distance(found[i], expected[i]), 1e-5f) << i;
}

// ---- Curves ----

// By de Casteljau.
glm::vec3 bezierAt(const glm::vec3* p, float t) {
  std::vector<glm::vec3> q(p, p + 4);
  for (std::size_t left = 3; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) q[i] = glm::mix(q[i], q[i + 1], t);
  return q[0];
}

// Mixes q over knots: de Boor's and Barry and Goldman's schemes differ in the knots alone.
glm::vec3 bsplineAt(const glm::vec3* p, float t) {
  std::vector<glm::vec3> q(p, p + 4);
  for (int level = 1; level <= 3; ++level)
    for (int i = 3; i >= level; --i) {
      const float from = static_cast<float>(i - 3), to = static_cast<float>(i - level + 1);
      q[static_cast<std::size_t>(i)] =
          glm::mix(q[static_cast<std::size_t>(i - 1)], q[static_cast<std::size_t>(i)],
                   (t - from) / (to - from));
    }
  return q[3];
}

glm::vec3 catmullRomAt(const glm::vec3* p, float t) {
  const auto knot = [](int i) { return static_cast<float>(i - 1); };
  std::vector<glm::vec3> q(p, p + 4);
  for (int level = 1; level <= 3; ++level)
    for (int i = 0; i + level <= 3; ++i) {
      // The last level runs over the middle segment alone.
      const int from = level == 3 ? 1 : i, to = level == 3 ? 2 : i + level;
      q[static_cast<std::size_t>(i)] =
          glm::mix(q[static_cast<std::size_t>(i)], q[static_cast<std::size_t>(i + 1)],
                   (t - knot(from)) / (knot(to) - knot(from)));
    }
  return q[0];
}

std::vector<glm::vec3> sampled(glm::vec3 (*at)(const glm::vec3*, float),
                               const std::vector<glm::vec3>& vertices, std::size_t step,
                               std::size_t segments, std::size_t steps) {
  std::vector<glm::vec3> points;
  for (std::size_t s = 0; s < segments; ++s)
    for (std::size_t i = 0; i < steps; ++i)
      points.push_back(
          at(vertices.data() + s * step, static_cast<float>(i) / static_cast<float>(steps)));
  points.push_back(at(vertices.data() + (segments - 1) * step, 1));
  return points;
}

TEST(UsdaScene, CubicCurvesAreEvaluated) {
  const auto read = [](const char* basis, const char* wrap, const std::vector<glm::vec3>& v) {
    const StrandFile file =
        readText(kHead + curves(cubic(basis, wrap), std::to_string(v.size()), v) + "}\n");
    EXPECT_EQ(file.strands.strandCount(), 1u);
    return file.strands.points;
  };
  for (const std::size_t n : {4u, 5u, 9u, 20u}) {
    const std::vector<glm::vec3> v = someVertices(n);
    std::vector<glm::vec3> ends = v, ring = v;
    ends.insert(ends.begin(), 2.0f * v[0] - v[1]);
    ends.push_back(2.0f * v[n - 1] - v[n - 2]);
    ring.insert(ring.begin(), v[n - 1]);
    ring.insert(ring.end(), {v[0], v[1]});
    const auto stepsOf = [](std::size_t segments) {
      return std::max<std::size_t>(2, (8 + segments - 1) / segments);
    };
    struct Basis {
      const char* name;
      glm::vec3 (*at)(const glm::vec3*, float);
    };
    for (const auto& [name, at] :
         {Basis{"bspline", bsplineAt}, Basis{"catmullRom", catmullRomAt}}) {
      expectNear(read(name, "nonperiodic", v), sampled(at, v, 1, n - 3, stepsOf(n - 3)), name);
      expectNear(read(name, "pinned", v), sampled(at, ends, 1, n - 1, stepsOf(n - 1)), name);
      expectNear(read(name, "periodic", v), sampled(at, ring, 1, n, stepsOf(n)), name);
    }
    EXPECT_LT(glm::distance(read("bspline", "pinned", v).back(), v.back()), 1e-6f);
  }
  for (const std::size_t n : {4u, 7u, 13u}) {
    const std::vector<glm::vec3> v = someVertices(n);
    const std::size_t segments = (n - 1) / 3,
                      steps = std::max<std::size_t>(4, (7 + segments) / segments);
    for (const char* wrap : {"nonperiodic", "pinned"})
      expectNear(read("bezier", wrap, v), sampled(bezierAt, v, 3, segments, steps), wrap);
    std::vector<glm::vec3> open(v.begin(), v.end() - 1), ring = v;
    ring.back() = v[0];
    expectNear(read("bezier", "periodic", open), sampled(bezierAt, ring, 3, segments, steps),
               "ring");
  }
}

TEST(UsdaScene, CurvesOfTooFewVerticesAreStraight) {
  for (const char* basis : {"bspline", "catmullRom", "bezier"})
    for (const std::size_t n : {2u, 3u}) {
      const std::vector<glm::vec3> v = someVertices(n);
      expectNear(readText(kHead + curves(cubic(basis, "nonperiodic"), std::to_string(n), v) + "}\n")
                     .strands.points,
                 v, basis);
    }
  // A straight line through two pinned ends.
  const std::vector<glm::vec3> v = someVertices(2);
  const auto line = readText(kHead + curves(cubic("catmullRom", "pinned"), "2", v) + "}\n");
  ASSERT_EQ(line.strands.pointCount(), 9u);
  EXPECT_LT(glm::distance(line.strands.points[2], glm::mix(v[0], v[1], 0.25f)), 1e-6f);
  // Closed lines are opened.
  const std::vector<glm::vec3> corners = someVertices(3);
  std::vector<glm::vec3> closed = corners;
  closed.push_back(corners[0]);
  expectNear(readText(kHead + curves(kLinear + "\ntoken wrap = \"periodic\"", "3", corners) + "}\n")
                 .strands.points,
             closed, "linear");
}

TEST(UsdaScene, ATypeThatIsNotStatedIsCubicIfItCanBe) {
  const std::vector<glm::vec3> seven = someVertices(7), six = someVertices(6);
  expectNear(readText(kHead + curves("", "7", seven) + "}\n").strands.points,
             sampled(bezierAt, seven, 3, 2, 4), "Bezier");
  expectNear(readText(kHead + curves("", "6", six) + "}\n").strands.points, six, "a line");
  const std::string stated = kHead + curves(cubic("bezier", "nonperiodic"), "6", six) + "}\n";
  EXPECT_NE(errorOf([&] { readText(stated); }).find("a Bezier curve has 4, 7, 10"),
            std::string::npos);
}

TEST(UsdaScene, ArraysFollowCurves) {
  const auto read = [](const std::string& more) {
    return readText(kHead + curves(cubic("bspline", "pinned"), "3, 2", someVertices(5)) + more +
                    "}\n");
  };
  // 3 vertices: 2 segments of 4; 2 vertices: 1 of 8.
  StrandFile file = read("float[] widths = [1, 2, 3, 4, 6] (interpolation = \"vertex\")\n");
  ASSERT_EQ(file.thickness.size(), 18u);
  EXPECT_FLOAT_EQ(file.thickness[0], 1);
  EXPECT_FLOAT_EQ(file.thickness[4], 2);
  EXPECT_FLOAT_EQ(file.thickness[9], 4);
  EXPECT_FLOAT_EQ(file.thickness[13], 5);
  file = read("float[] widths = [1, 2, 3, 4, 6] (interpolation = \"varying\")\n");
  EXPECT_FLOAT_EQ(file.thickness[2], 1.5f);
  EXPECT_FLOAT_EQ(file.thickness[17], 6);
  file = read("float[] widths = [1, 2] (interpolation = \"uniform\")\n");
  EXPECT_FLOAT_EQ(file.thickness[8], 1);
  EXPECT_FLOAT_EQ(file.thickness[9], 2);
  file = read(
      "color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] (interpolation = "
      "\"uniform\")\nint[] primvars:displayColor:indices = [1, 0]\n");
  EXPECT_EQ(file.colours[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(file.colours[17], glm::vec3(1, 0, 0));
  EXPECT_NE(
      errorOf([&] {
        read(
            "float[] widths = [1] (interpolation = \"uniform\")\nint[] "
            "primvars:displayColor:indices = [3]\ncolor3f[] primvars:displayColor = [(1, 0, 0)]");
      }).find("1 values for 2 curves"),
      std::string::npos);
}

// ---- Transforms ----

std::string placed(const std::string& ops, const std::string& order, const std::string& inside) {
  return "def Xform \"Place\" {\n" + ops + "\nuniform token[] xformOpOrder = [" + order + "]\n" +
         inside + "}\n";
}

const std::vector<glm::vec3> kPoints = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 2, 3}};

std::vector<glm::vec3> readPlaced(const std::string& ops, const std::string& order) {
  return readText(kHead + placed(ops, order, curves(kLinear, "2, 2", kPoints) + "}\n"))
      .strands.points;
}

template <class Map>
std::vector<glm::vec3> mapped(Map&& map, std::vector<glm::vec3> points = kPoints) {
  for (glm::vec3& p : points) p = map(p);
  return points;
}

// By quarter turns, about an axis, right-handed.
glm::vec3 aboutX(glm::vec3 p) {
  return {p.x, -p.z, p.y};
}
glm::vec3 aboutY(glm::vec3 p) {
  return {p.z, p.y, -p.x};
}
glm::vec3 aboutZ(glm::vec3 p) {
  return {-p.y, p.x, p.z};
}

TEST(UsdaScene, EveryOperationOfATransform) {
  expectNear(readPlaced("double3 xformOp:translate = (1, 2, 3)", "\"xformOp:translate\""),
             mapped([](glm::vec3 p) { return p + glm::vec3(1, 2, 3); }), "translate");
  expectNear(readPlaced("float3 xformOp:scale = (2, 3, 4)", "\"xformOp:scale\""),
             mapped([](glm::vec3 p) { return p * glm::vec3(2, 3, 4); }), "scale");
  expectNear(readPlaced("float xformOp:rotateX = 90", "\"xformOp:rotateX\""), mapped(aboutX), "X");
  expectNear(readPlaced("float xformOp:rotateY = 90", "\"xformOp:rotateY\""), mapped(aboutY), "Y");
  expectNear(readPlaced("float xformOp:rotateZ = 90", "\"xformOp:rotateZ\""), mapped(aboutZ), "Z");
  const float h = std::sqrt(0.5f);
  expectNear(
      readPlaced(text("quatf xformOp:orient = (", h, ", ", h, ", 0, 0)"), "\"xformOp:orient\""),
      mapped(aboutX), "orient");
  // The named order is that of the turns; the numbers are x, y, z.
  expectNear(readPlaced("float3 xformOp:rotateXYZ = (90, 90, 0)", "\"xformOp:rotateXYZ\""),
             mapped([](glm::vec3 p) { return aboutY(aboutX(p)); }), "XYZ");
  expectNear(readPlaced("float3 xformOp:rotateYXZ = (90, 90, 0)", "\"xformOp:rotateYXZ\""),
             mapped([](glm::vec3 p) { return aboutX(aboutY(p)); }), "YXZ");
  expectNear(readPlaced("float3 xformOp:rotateZYX = (90, 0, 90)", "\"xformOp:rotateZYX\""),
             mapped([](glm::vec3 p) { return aboutX(aboutZ(p)); }), "ZYX");
  // Rows: where x, y, z and the origin go.
  expectNear(readPlaced("matrix4d xformOp:transform = ( (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), "
                        "(5, 6, 7, 1) )",
                        "\"xformOp:transform\""),
             mapped([](glm::vec3 p) { return aboutZ(p) + glm::vec3(5, 6, 7); }), "transform");
}

TEST(UsdaScene, OperationsGoFromTheLastToTheFirst) {
  const std::string ops =
      "double3 xformOp:translate = (1, 2, 3)\nfloat xformOp:rotateZ = 90\n"
      "float3 xformOp:scale = (2, 3, 4)\ndouble3 xformOp:translate:pivot = (0, 1, 0)";
  expectNear(
      readPlaced(ops, "\"xformOp:translate\", \"xformOp:rotateZ\", \"xformOp:scale\""),
      mapped([](glm::vec3 p) { return aboutZ(p * glm::vec3(2, 3, 4)) + glm::vec3(1, 2, 3); }),
      "TRS");
  expectNear(
      readPlaced(ops,
                 "\"xformOp:translate:pivot\", \"xformOp:rotateZ\", "
                 "\"!invert!xformOp:translate:pivot\""),
      mapped([](glm::vec3 p) { return aboutZ(p - glm::vec3(0, 1, 0)) + glm::vec3(0, 1, 0); }),
      "about a pivot");
  expectNear(readPlaced(ops, "\"!invert!xformOp:scale\", \"!invert!xformOp:rotateZ\""),
             mapped([](glm::vec3 p) { return aboutZ(aboutZ(aboutZ(p))) / glm::vec3(2, 3, 4); }),
             "inverses");
  // What is not in the order does not count.
  expectNear(readPlaced(ops, ""), kPoints, "no order");
}

TEST(UsdaScene, TransformsAboveAndResets) {
  const std::string move = "double3 xformOp:translate = (1, 0, 0)",
                    turn = "float xformOp:rotateZ = 90";
  const std::string inside = curves(kLinear, "2, 2", kPoints) + "}\n";
  const auto nested = [&](const std::string& outer, const std::string& inner) {
    return readText(kHead + placed(move, outer, placed(turn, inner, inside))).strands.points;
  };
  expectNear(nested("\"xformOp:translate\"", "\"xformOp:rotateZ\""),
             mapped([](glm::vec3 p) { return aboutZ(p) + glm::vec3(1, 0, 0); }), "both");
  expectNear(nested("\"xformOp:translate\"", "\"!resetXformStack!\", \"xformOp:rotateZ\""),
             mapped(aboutZ), "reset");
  // On the curves themselves; widths grow with them.
  const StrandFile own = readText(
      kHead + curves(kLinear, "2, 2", kPoints) +
      "float[] widths = [0.5] (interpolation = \"constant\")\nfloat3 xformOp:scale = (3, 3, 3)\n"
      "uniform token[] xformOpOrder = [\"xformOp:scale\"]\n}\n");
  expectNear(own.strands.points, mapped([](glm::vec3 p) { return 3.0f * p; }), "own");
  EXPECT_FLOAT_EQ(own.defaultThickness, 1.5f);
}

TEST(UsdaScene, TransformsMove) {
  const std::string still = curves(kLinear, "2, 2", kPoints) + "}\n";
  const std::string bytes =
      kHead + placed("double3 xformOp:translate.timeSamples = { 1: (0, 0, 0), 3: (4, 0, 0) }",
                     "\"xformOp:translate\"",
                     placed("float xformOp:rotateZ.timeSamples = { 2: 0, 3: 90 }",
                            "\"xformOp:rotateZ\"", still));
  ASSERT_EQ(framesOf(bytes), 3u);  // at 1, 2 and 3
  expectNear(readText(bytes, {}, 0).strands.points, kPoints, "1");
  expectNear(readText(bytes, {}, 1).strands.points,
             mapped([](glm::vec3 p) { return p + glm::vec3(2, 0, 0); }), "2: half of the way");
  expectNear(readText(bytes, {}, 2).strands.points,
             mapped([](glm::vec3 p) { return aboutZ(p) + glm::vec3(4, 0, 0); }), "3");
  // Points between their samples.
  std::string moving = kHead + placed(
                                   "double3 xformOp:translate.timeSamples = { 1: (0, 0, 0), "
                                   "2: (0, 0, 0), 3: (0, 0, 0) }",
                                   "\"xformOp:translate\"", still);
  const std::size_t at = moving.find("point3f[] points = ");
  moving.replace(at, moving.find('\n', at) - at,
                 "point3f[] points.timeSamples = { 1: " + vectors(kPoints) +
                     ", 3: " + vectors(mapped([](glm::vec3 p) { return 3.0f * p; })) + "}");
  expectNear(readText(moving, {}, 1).strands.points, mapped([](glm::vec3 p) { return 2.0f * p; }),
             "half of the way");
}

// ---- Several prims ----

TEST(UsdaScene, PrimsAreJoinedOrChosen) {
  const std::vector<glm::vec3> other = mapped([](glm::vec3 p) { return p + glm::vec3(9, 0, 0); });
  const std::string bytes = kHead + "def Xform \"Head\" {\n" + curves(kLinear, "2, 2", kPoints) +
                            "float[] widths = [1, 2, 3, 4] (interpolation = \"vertex\")\n}\n" +
                            curves(kLinear, "4", other, "Brows") + "float[] widths = [7]\n}\n}\n" +
                            curves(kLinear, "", {}, "Empty") + "}\n";
  const StrandFile both = readText(bytes);
  EXPECT_EQ(both.strands.first, (std::vector<std::uint32_t>{0, 2, 4, 8}));
  EXPECT_EQ(both.thickness, (std::vector<float>{1, 2, 3, 4, 7, 7, 7, 7}));
  ASSERT_EQ(both.notes.size(), 1u);
  EXPECT_NE(both.notes[0].find("joined: /Head/Hair, /Head/Brows"), std::string::npos)
      << both.notes[0];
  for (const char* prim : {"Brows", "/Head/Brows", "Head/Brows"}) {
    const StrandFile brows = readText(bytes, prim);
    expectNear(brows.strands.points, other, prim);
    EXPECT_EQ(brows.defaultThickness, 7);
    EXPECT_TRUE(brows.notes.empty());
  }
  EXPECT_EQ(readText(bytes, "/Head").strands.strandCount(), 3u);
  EXPECT_NE(errorOf([&] { readText(bytes, "Beard"); }).find("there are /Head/Hair, /Head/Brows"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { readText(bytes, "/Hea"); }).find("no BasisCurves at --prim /Hea"),
            std::string::npos);
}

TEST(UsdaScene, HiddenAndAbstractOnesAreLeftOut) {
  const std::string hair = curves(kLinear, "2, 2", kPoints) + "}\n";
  const std::string guides = curves(kLinear, "4", kPoints, "Guides");
  EXPECT_EQ(readText(kHead + hair + guides + "token visibility = \"invisible\"\n}\n")
                .strands.strandCount(),
            2u);
  EXPECT_EQ(readText(kHead + "class \"c\" {\n" + guides + "}\n}\n" + hair).strands.strandCount(),
            3u);
  EXPECT_EQ(readText(kHead + "def Xform \"x\" (active = false) {\n" + guides + "}\n}\n" + hair)
                .strands.strandCount(),
            2u);
  std::string over = guides;
  over.replace(0, 3, "over");
  EXPECT_EQ(readText(kHead + over + "}\n" + hair).strands.strandCount(), 2u);
}

TEST(UsdaScene, TheChosenVariantCounts) {
  const auto lengths = [](const std::string& chosen) {
    const std::string bytes =
        kHead + "def Xform \"Model\" (\n" +
        (chosen.empty() ? "" : "variants = { string style = \"" + chosen + "\" }\n") +
        "prepend variantSets = \"style\"\n) {\n  float xformOp:rotateZ = 0\n  variantSet \"style\" "
        "= "
        "{\n\"long\" {\n" +
        curves(kLinear, "4", kPoints) + "}\n}\n\"short\" (kind = \"a\") {\n" +
        curves(kLinear, "2, 2", kPoints) +
        "}\nfloat xformOp:rotateZ = 90\ntoken[] xformOpOrder = [\"xformOp:rotateZ\"]\n}\n}\n}\n";
    const StrandFile file = readText(bytes);
    // What the prim itself states is stronger: no turn.
    EXPECT_LT(glm::distance(file.strands.points[0], kPoints[0]), 1e-6f);
    EXPECT_EQ(file.notes.size(), chosen.empty() ? 1u : 0u);
    return file.strands.strandCount();
  };
  EXPECT_EQ(lengths("long"), 1u);
  EXPECT_EQ(lengths("short"), 2u);
  EXPECT_EQ(lengths(""), 1u);  // the first
}

TEST(UsdaScene, WhatBlenderWrites) {
  // Of its own scale and axes: hair on a head that stands and is turned, in metres, +Z up.
  const std::string bytes =
      "#usda 1.0\n(\n    defaultPrim = \"root\"\n    doc = \"Blender v4.0.2\"\n    metersPerUnit = "
      "1\n"
      "    upAxis = \"Z\"\n)\n\ndef Xform \"root\"\n{\n    def Xform \"Head\"\n    {\n"
      "        float3 xformOp:rotateXYZ = (0, 0, 90)\n        float3 xformOp:scale = (1, 1, 1)\n"
      "        double3 xformOp:translate = (0, 0, 1.5)\n"
      "        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateXYZ\", "
      "\"xformOp:scale\"]\n\n        def Mesh \"Head\" (\n            active = true\n        )\n"
      "        {\n            int[] faceVertexCounts = [3]\n        }\n\n" +
      curves(cubic("catmullRom", "pinned"), "2, 2", kPoints, "Curves") +
      "            float3[] extent = [(0, 0, 0), (1, 2, 3)]\n"
      "            float[] widths = [0.1, 0.2, 0.3, 0.4] (\n                interpolation = "
      "\"varying\"\n            )\n            string userProperties:blender:data_name = "
      "\"Curves\"\n"
      "        }\n    }\n}\n";
  const TemporaryFolder folder;
  const StrandFile file = readStrands(folder.write("blender.usda", bytes));
  ASSERT_EQ(file.strands.pointCount(), 18u);
  const auto library = [](glm::vec3 p) {
    p = aboutZ(p) + glm::vec3(0, 0, 1.5f);
    return glm::vec3(p.x, p.z, -p.y);
  };
  EXPECT_LT(glm::distance(file.strands.points[0], library(kPoints[0])), 1e-5f);
  EXPECT_LT(glm::distance(file.strands.points[17], library(kPoints[3])), 1e-5f);
  EXPECT_FLOAT_EQ(file.thickness[17], 0.4f);
}

TEST(UsdaScene, DamageIsAnError) {
  const std::string inside = curves(kLinear, "2, 2", kPoints) + "}\n";
  const auto says = [&](const std::string& bytes, const char* words) {
    const std::string message = errorOf([&] { readText(bytes); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says(kHead + placed("float xformOp:spin = 1", "\"xformOp:spin\"", inside),
       "'xformOp:spin' is no transform");
  says(kHead + placed("float3 xformOp:scale = (0, 1, 1)", "\"!invert!xformOp:scale\"", inside),
       "has no inverse");
  says(kHead + placed("float3 xformOp:scale = (1, 1)", "\"xformOp:scale\"", inside),
       "a.usda: line");
  says(kHead + placed("float3 xformOp:scale = (1e300, 1, 1)", "\"xformOp:scale\"", inside),
       "beyond all numbers");
  std::string deep = kHead;
  for (int i = 0; i < 1200; ++i) deep += "def \"a\" {\n";
  says(deep, "prims inside one another");
}

}  // namespace
}  // namespace hair

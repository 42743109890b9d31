#include <libhair/hair_mesh/script/script.h>

#include <gtest/gtest.h>

#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/surface.h>
#include <tests/files/samples.h>
#include <tests/hair_mesh/same_mesh.h>

namespace hair {
namespace {

Hairstyle styleOf(const std::string& script, ScriptFiles files = {}, ScriptLimits limits = {}) {
  return applyScript(parseHairMeshScript(script, "a.hairmesh"), std::move(files), limits);
}

std::string errorOfScript(const std::string& script, ScriptLimits limits = {}) {
  return errorOf([&] { styleOf(script, {}, limits); });
}

// A ring of triangles (bundles 0 to 5) and one of quads (6 to 11), 3 layers high.
const std::string kStart = "scalp sphere 0.1 2 6\nextrude all 0.02 times 3\n";

TEST(Script, EveryOperationChangesTheMeshAndLeavesItValid) {
  for (const char* line : {
           "extrude all 0.01",
           "extrude front 0.01 towards 0 0 1 0.5 times 2",
           "delete front",
           "delete front times 4",
           "insert 2 all",
           "remove 2 front",
           "separate front",
           "separate front from back at 2",
           "separate parting",
           "separate whorl",
           "separate-vertices front at 2",
           "divide-face 7 0 2",
           "divide-edge 7 1",
           "subdivide catmull-clark",
           "subdivide catmull-clark flat",
           "move front 0.01 0 0",
           "move front at 2 0.01 0 0",
           "move front at 1..2 ramp 0.01 0 0",
           "scale all at tip about 0 0.1 0 by 2 1 2",
           "rotate all ramp 30 axis 0 1 0",
           "rotate all 30 about 0 0 0.1",
           "gather all at 2..3 0 0.3 0 0.5",
           "fall all 0.5",
           "smooth all ramp 0.5 times 2",
           "keep-out all at 1 0.05",
           "pin front at 2..3",
           "drape all 5 length 0.2 lift 0.5 stiffness 0.05 clearance 0.002 volume 0.01",
           "sweep front 4 through 0 0.2 0.2 0 0 0.3 scale 0.5 twist 90",
           "sweep front 4 scale 0.5 through 0 0.2 0.2 0 0 0.3",
           "coil all 8 about 0 0.1 0 axis 0 1 0 turns 1 radius 0.03 rise 0.01 scale 0.5 twist 10",
       }) {
    const std::string start = kStart + "select front z > 0\nselect back not front\n";
    const Hairstyle before = styleOf(start);
    Hairstyle after;
    ASSERT_NO_THROW(after = styleOf(start + line)) << line << ": " << errorOfScript(start + line);
    EXPECT_EQ(whyInvalid(after.mesh), "") << line;
    EXPECT_FALSE(test::identical(before.mesh, after.mesh)) << line;
    // The scalp is the head's: no vertex of it moves, but for subdivision and new vertices on it.
    for (std::size_t v = 0; v < before.mesh.layers[0].vertexCount() &&
                            !std::string_view(line).starts_with("subdivide catmull-clark") &&
                            !std::string_view(line).starts_with("delete");
         ++v)
      EXPECT_EQ(before.mesh.layers[0].positions[v], after.mesh.layers[0].positions[v]) << line;
  }
}

TEST(Script, WhatIsSeparatedIsWelded) {
  const Hairstyle start = styleOf(kStart);
  for (const char* lines :
       {"select a z > 0\nseparate a at 2\nweld a at 2\nweld a at 3",
        "separate parting at 3\nweld parting at 3",
        "select a sector = 1\nselect b sector = 2\nseparate a from b at 3\nweld b with a at 3"}) {
    const Hairstyle welded = styleOf(kStart + lines);
    EXPECT_TRUE(test::Unnumbered(welded.mesh).firstOf == test::Unnumbered(start.mesh).firstOf)
        << lines;
  }
  // By numbers: an edge from the rim, of bundle 7.
  const auto face = start.mesh.face(3, 7);
  EXPECT_EQ(styleOf(kStart + text("separate-edge 3 ", face[0], ' ', face[1]))
                .mesh.layers[3]
                .vertexCount(),
            start.mesh.layers[3].vertexCount() + 1);
  // The parted vertices of one place of the scalp.
  const Hairstyle parted = styleOf(kStart + "separate-vertices all at 3\n");
  const HairMesh& mesh = parted.mesh;
  const auto at = [&](std::uint32_t c) { return mesh.layers[3].corners[c]; };
  const std::uint32_t a = mesh.firstCorner[6], b = mesh.firstCorner[7];
  EXPECT_EQ(styleOf(kStart + "separate-vertices all at 3\n" +
                    text("weld-edges 3 ", at(a + 2), ' ', at(a + 3), ' ', at(b + 1), ' ', at(b)))
                .mesh.layers[3]
                .vertexCount(),
            mesh.layers[3].vertexCount() - 2);
  EXPECT_NE(errorOfScript(kStart + "separate-vertices all at 3\n" +
                          text("weld-vertices 3 ", at(a), ' ', at(b + 1))),
            "");
}

TEST(Script, SelectionsAreSetsThatFollowTheirBundles) {
  const auto count = [](const std::string& lines) {
    // What is selected is as long as it is told, all else one layer.
    const Hairstyle style = styleOf(kStart + "delete all times 3\n" + lines + "\nextrude s 0.01\n");
    std::size_t selected = 0;
    for (const std::uint32_t n : style.mesh.lastLayer) selected += n > 0;
    return selected;
  };
  EXPECT_EQ(count("select s all"), 12u);
  EXPECT_EQ(count("select s rim"), 6u);
  EXPECT_EQ(count("select s ring = 0"), 6u);
  EXPECT_EQ(count("select s sector <= 1"), 4u);
  EXPECT_EQ(count("select s bundles 3"), 1u);
  EXPECT_EQ(count("select s bundles 3..5 or bundles 5..7"), 5u);
  EXPECT_EQ(count("select s not rim minus bundles 0"), 5u);
  EXPECT_EQ(count("select a x > 0\nselect s a and ring = 1"), 3u);
  EXPECT_EQ(count("select s all where sides = 3"), 6u);
  EXPECT_EQ(count("select s angle > 0 and angle < 60"), 2u);
  EXPECT_EQ(count("select s tip-y > 0.07 and tip-x > -1 and tip-z >= -1"), 6u);
  EXPECT_EQ(count("select s length = 0 and layers = 0"), 12u);
  EXPECT_EQ(count("select s bundles 7\nsubdivide catmull-clark"), 4u);
  EXPECT_EQ(count("select s bundles 7\ndivide-face 7 0 2"), 2u);
  EXPECT_EQ(count("select s bundles 7\nselect t bundles 0..4\ndelete t"), 1u);
}

TEST(Script, PinnedVerticesStayAndAutoPlaceCanBeOff) {
  const std::string bent = kStart + "move all at tip 0.03 0 0\n";
  const Hairstyle placed = styleOf(bent), by = styleOf(kStart +
                                                       "auto-place off\nmove all at tip "
                                                       "0.03 0 0\n");
  EXPECT_FALSE(test::identical(placed.mesh, by.mesh));
  EXPECT_TRUE(test::identical(placed.mesh, styleOf(kStart + "auto-place off\nmove all at tip 0.03 "
                                                            "0 0\nplace\n")
                                               .mesh));
  EXPECT_TRUE(test::identical(placed.mesh, styleOf(kStart + "auto-place off\nauto-place on\nmove "
                                                            "all at tip 0.03 0 0\n")
                                               .mesh));
  const auto inside = exteriorVertices(placed.mesh);
  const Hairstyle pinned = styleOf(kStart + "pin all\nmove all at tip 0.03 0 0\n");
  const Hairstyle start = styleOf(kStart);
  const Hairstyle loose = styleOf(kStart + "pin all\nunpin all\nmove all at tip 0.03 0 0\n");
  for (std::uint32_t k = 0; k < 4; ++k)
    for (std::size_t v = 0; v < inside[k].size(); ++v)
      EXPECT_LT(
          glm::distance(placed.mesh.layers[k].positions[v], loose.mesh.layers[k].positions[v]),
          1e-5f);
  for (std::uint32_t k = 1; k < 3; ++k)
    for (std::size_t v = 0; v < inside[k].size(); ++v)
      EXPECT_EQ(pinned.mesh.layers[k].positions[v], start.mesh.layers[k].positions[v]);
}

TEST(Script, GroupsAreWhatTheyAreToldToBe) {
  const Hairstyle style = styleOf(
      kStart +
      "group strands 500 points 9 seed 3 length-cut 0.1 length-variation 0.2 clump 0.3 "
      "clump-size 7 curl-radius 0.01 curl-pitch 0.02 curl-from-root 0.25 noise 0.004 noise-length "
      "0.05 per-square-metre 9e4 frizz 0.002 frizz-length 0.006 frizz-share 0.5   # all of "
      "them\ngroup\n");
  ASSERT_EQ(style.groups.size(), 2u);
  const StrandGroup& g = style.groups[0];
  EXPECT_EQ(g.strands, 500u);
  EXPECT_EQ(g.points, 9u);
  EXPECT_EQ(g.seed, 3u);
  EXPECT_EQ(g.styling.lengthCut, 0.1f);
  EXPECT_EQ(g.styling.lengthVariation, 0.2f);
  EXPECT_EQ(g.styling.clump, 0.3f);
  EXPECT_EQ(g.styling.clumpSize, 7u);
  EXPECT_EQ(g.styling.curlRadius, 0.01f);
  EXPECT_EQ(g.styling.curlPitch, 0.02f);
  EXPECT_EQ(g.styling.curlFromRoot, 0.25f);
  EXPECT_EQ(g.styling.noise, 0.004f);
  EXPECT_EQ(g.styling.noiseLength, 0.05f);
  EXPECT_EQ(g.styling.frizz, 0.002f);
  EXPECT_EQ(g.styling.frizzLength, 0.006f);
  EXPECT_EQ(g.styling.frizzShare, 0.5f);
  EXPECT_EQ(g.perSquareMetre, 9e4f);
  EXPECT_EQ(style.groups[1].strands, StrandGroup().strands);
}

TEST(Script, ErrorsNameFileLineAndCause) {
  const auto atLine4 = [](const std::string& line) {
    const std::string error = errorOfScript(kStart + "\n" + line + "\n");
    const std::string start = "a.hairmesh: line 4: ";
    EXPECT_TRUE(error.starts_with(start)) << line << " | " << error;
    return error.substr(std::min(start.size(), error.size()));
  };
  EXPECT_EQ(atLine4("extrud all 1"), "there is no operation 'extrud'");
  EXPECT_EQ(atLine4("extrude"), "a selection is missing at the end of the line");
  EXPECT_EQ(atLine4("extrude all"), "distance is missing at the end of the line");
  EXPECT_EQ(atLine4("extrude all far"), "distance: 'far' is no finite number");
  EXPECT_EQ(atLine4("extrude all nan"), "distance: 'nan' is no finite number");
  EXPECT_EQ(atLine4("extrude all 5"), "distance: 5 is not in -1 to 1");
  EXPECT_EQ(atLine4("extrude all 0.1 up"),
            "'up' is not understood here; there are: towards, times");
  EXPECT_EQ(atLine4("extrude all 0.1 times 2 times 2"), "'times' is there twice");
  EXPECT_EQ(atLine4("extrude all 0.1 times 0"), "times: 0 is not in 1 to 1000");
  EXPECT_EQ(atLine4("extrude fringe 0.1"),
            "there is no selection 'fringe'; `select fringe ...` makes one");
  EXPECT_EQ(atLine4("place now"), "'now' is not understood here");
  EXPECT_EQ(atLine4("select all x < 0"), "'all' has a meaning already");
  EXPECT_EQ(atLine4("select s x ~ 0"), "'~' is none of <, <=, >, >= and =");
  EXPECT_EQ(atLine4("select s x < 0 x > 0"), "after a set comes `and`, `or`, `minus` or `where`");
  EXPECT_EQ(atLine4("select s y > 3"), "'s' holds no bundle");
  EXPECT_EQ(atLine4("select s bundles 12"), "there is no bundle 12; there are 12, from 0");
  EXPECT_EQ(atLine4("move all at 2..1 0 0 0"), "layers: 1 is not in 2 to 100000");
  EXPECT_EQ(atLine4("move all at 0 0 0 0"), "layers: 0 is not in 1 to 100000");
  EXPECT_EQ(atLine4("move all at 9 0 0 0"), "'all' has no vertex above the scalp in these layers");
  EXPECT_EQ(atLine4("insert 9 all"), "no bundle of 'all' has a layer 9");
  EXPECT_EQ(atLine4("delete all times 5"), "nothing of the scalp would be left");
  EXPECT_EQ(atLine4("scalp head 2 8"), "there is a scalp already");
  EXPECT_EQ(atLine4("scalp file a.obj"), "files are not read here: 'a.obj'");
  EXPECT_EQ(atLine4("rotate all 9 axis 0 0 0"), "axis: a direction has a length");
  EXPECT_EQ(atLine4("comb all 4"),
            "only hair of the built-in head is combed; `drape` is for others");
  EXPECT_EQ(atLine4("coil all 4 turns 1"), "`axis X Y Z` is missing");
  EXPECT_EQ(atLine4("sweep all 4"), "`through X Y Z ...` is missing");
  EXPECT_EQ(atLine4("pull all 4 to 0 0.1 0"), "to: this point is inside of the head");
  EXPECT_NE(atLine4("separate-edge 1 0 99"), "");
  EXPECT_NE(atLine4("subdivide loop"), "");
  EXPECT_NE(atLine4("separate all"), "");
  EXPECT_NE(errorOfScript("extrude all 1").find("line 1: there is no scalp yet"),
            std::string::npos);
  EXPECT_EQ(errorOfScript("# nothing\n").find("a.hairmesh: no scalp"), 0u);
  EXPECT_NE(errorOf([] { readHairMeshScript("/no/such.hairmesh"); }).find("/no/such.hairmesh"),
            std::string::npos);
}

TEST(Script, ALineThatFailsChangesNothing) {
  ScriptRun run;
  const HairMeshScript script = parseHairMeshScript(
      kStart +
          "group strands 5\nselect a x > 0\nextrude all 0.01 times 40\nselect a x > 9\n"
          "delete all times 9\nsubdivide loop\nmove a at tip 10 10 10\n",
      "a.hairmesh");
  for (std::size_t line = 0; line < 4; ++line) run.apply(script, line);
  const Hairstyle before = run.style();
  ScriptRun narrow({}, {.corners = 500});
  for (std::size_t line = 0; line < 4; ++line) narrow.apply(script, line);
  EXPECT_THROW(narrow.apply(script, 4), Error);  // after some of its forty layers
  EXPECT_TRUE(test::identical(narrow.style().mesh, before.mesh));
  for (const std::size_t line : {5u, 6u, 7u}) {
    EXPECT_THROW(run.apply(script, line), Error) << line;
    EXPECT_TRUE(test::identical(run.style().mesh, before.mesh)) << line;
    EXPECT_EQ(run.style().groups.size(), 1u);
  }
  run.apply(script, 8);  // `a` is what it was
}

TEST(Script, LimitsAreNamed) {
  const auto error = [](const char* lines, const ScriptLimits& limits) {
    return errorOfScript(kStart + lines, limits);
  };
  EXPECT_NE(error("", {.lines = 1}).find("line 2: a script may have 1 operations"),
            std::string::npos);
  EXPECT_NE(error("subdivide catmull-clark\n", {.corners = 500}).find("at most 500"),
            std::string::npos);
  EXPECT_NE(error("smooth all 0.1 times 9\n", {.work = 1500}).find("too much work"),
            std::string::npos);
  EXPECT_NE(error("drape all 1000\n", {.corners = 500}).find("at most 500"), std::string::npos);
  EXPECT_NE(error("sweep all 1000 through 1 1 1\n", {.corners = 500}).find("at most 500"),
            std::string::npos);
  // One bundle of many layers, for which all others keep empty arrays.
  EXPECT_NE(error("select a bundles 0\nsweep a 100 through 1 1 1\n", {.corners = 500})
                .find("most of them empty"),
            std::string::npos);
  EXPECT_NE(errorOfScript("scalp sphere 1 100 400\n", {.corners = 500}).find("at most 500"),
            std::string::npos);
}

TEST(Script, FilesThatItNamesStandBesideIt) {
  const TemporaryFolder folder;
  folder.write("patch.obj", sampleObj());
  const std::filesystem::path file =
      folder.write("a.hairmesh", "scalp file patch.obj\nextrude all 0.1\n");
  const Hairstyle style = applyScript(readHairMeshScript(file), filesBeside(file));
  EXPECT_EQ(style.mesh.bundleCount(), 2u);
  EXPECT_EQ(style.mesh.sides(1), 3u);
  const std::string error =
      errorOf([&] { styleOf("scalp file b.obj\n", [](const std::string&) { return "v 0 0\n"; }); });
  EXPECT_EQ(
      error,
      "a.hairmesh: line 1: b.obj: line 1: vertex: a number is missing at the end of the line");
}

TEST(Script, AnIncludedScriptStandsWhereItIsNamed) {
  const auto files = [](const std::string& name) -> std::string {
    if (name == "mesh.hairmesh")
      return "scalp sphere 0.1 1 4\nselect half ring = 0\ninclude up.hairmesh\ngroup strands 7\n";
    if (name == "up.hairmesh") return "extrude half 0.05\n";
    if (name == "wrong.hairmesh") return "scalp sphere 0.1 1 4\nextrude none 0.05\n";
    return "include " + name + "\n";  // itself
  };
  const Hairstyle plain = styleOf("scalp sphere 0.1 1 4\nextrude all 0.05\nextrude all 0.01\n");
  const Hairstyle style = styleOf("include mesh.hairmesh\nextrude half 0.01\ngroup\n", files);
  EXPECT_TRUE(test::identical(style.mesh, plain.mesh));
  EXPECT_EQ(style.groups.size(), 2u);
  EXPECT_EQ(styleOf("include mesh.hairmesh\ngroups none\ngroup strands 9\n", files).groups.size(),
            1u);
  const std::string wrong = errorOf([&] { styleOf("include wrong.hairmesh\n", files); });
  EXPECT_NE(wrong.find("a.hairmesh: line 1: wrong.hairmesh: line 2: "), std::string::npos) << wrong;
  const std::string endless = errorOf([&] { styleOf("include again.hairmesh\n", files); });
  EXPECT_NE(endless.find("8 deep"), std::string::npos) << endless;
  // Its lines count.
  EXPECT_THROW(styleOf("include mesh.hairmesh\n", files, {.lines = 4}), Error);
  EXPECT_NO_THROW(styleOf("include mesh.hairmesh\n", files, {.lines = 6}));
}

TEST(Script, TiesFollowTheirBundles) {
  const Hairstyle style = styleOf(
      "scalp sphere 0.1 1 4\nextrude all 0.05 times 3\nselect first bundles 1..1\n"
      "tie first at 2\nselect last bundles 3..3\ntie last\n"
      "select gone bundles 0..0\ndelete gone times 4\n");
  EXPECT_EQ(style.tied, (std::vector<std::uint32_t>{2, 0, 3}));
}

}  // namespace
}  // namespace hair

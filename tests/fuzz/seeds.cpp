#include "seeds.h"

#include <algorithm>
#include <sstream>

#include <libhair/files/ply_file.h>
#include <libhair/files/usda/usda_write.h>
#include <tests/files/samples.h>

#include "small_hair.h"

namespace hair {

namespace {

// With and without each optional array, strands of equal and of other lengths.
std::vector<std::string> hairSeeds() {
  std::vector<std::string> seeds;
  for (int arrays = 0; arrays < 8; ++arrays) {
    HairFile hair = sampleHair();
    if (!(arrays & 1)) hair.thickness.clear();
    if (!(arrays & 2)) hair.transparency.clear();
    if (!(arrays & 4)) hair.colours.clear();
    seeds.push_back(hairBytes(hair));
  }
  HairFile equal;
  for (const float x : {0.0f, 1.0f})
    equal.strands.append(std::vector<glm::vec3>{{x, 0, 0}, {x, 1, 0}});
  equal.info = std::string(88, 'i');
  seeds.push_back(hairBytes(equal));
  return seeds;
}

// Without strand UV; and with offsets of all the arrays that are only checked.
std::vector<std::string> tfxSeeds() {
  const std::string full = sampleTfx();
  std::string all = full;
  for (const std::size_t field : {24, 28, 32}) all = withBytes(all, field, std::uint32_t{200});
  return {full, withBytes(full, 20, 0u), all};
}

std::vector<std::string> dataSeeds() {
  std::string one;
  putBytes(one, std::int32_t{1});
  putBytes(one, std::int32_t{1});
  for (const float c : {1.0f, 2.0f, 3.0f}) putBytes(one, c);
  return {sampleData(), one};
}

// Text with everything; and binary with every array.
std::vector<std::string> plySeeds() {
  const HairFile hair = sampleHair();
  StrandFile file;
  file.strands = hair.strands;
  file.thickness = hair.thickness;
  file.transparency = hair.transparency;
  file.colours = hair.colours;
  std::ostringstream binary, bare;
  writePly(binary, file);
  file.thickness.clear();
  file.transparency.clear();
  file.colours.clear();
  writePly(bare, file);
  const std::string vertices =
                        "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n",
                    points = "0 0 0\n0 1 0\n0 2 0\n9 0 0\n9 1 0\n9 2 0\n";
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty "
      "float y\nproperty float z\nproperty short strand_id\nend_header\n";
  big += std::string("\x3f\x80\0\0\0\0\0\0\xc0\0\0\0\0\1", 14);
  return {samplePlyText(),
          binary.str(),
          bare.str(),
          big,
          "ply\nformat ascii 1.0\n" + vertices + "end_header\n" + points,
          "ply\nformat ascii 1.0\n" + vertices +
              "element polyline 2\nproperty list uchar int vertex_index\nend_header\n" + points +
              "3 0 1 2\n3 3 4 5\n"};
}

// Both kinds of points, both ways of packing.
std::vector<std::string> numpySeeds() {
  return {sampleNpy(), sampleNpz(false), sampleNpz(true)};
}

// As written, as modellers write it (edges), and with faces besides.
std::vector<std::string> lineSeeds() {
  return {sampleObjLines(), "v 0 0 0\nv 0 1 0\nv 0 2 0\nl 1 2\nl 2 3\n",
          "# libhair: 0.01 m a unit, +Z up, -Y face\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"
          "l -1 -2 -3\np 1 2\n"};
}

// By hand; and as written, still and moving, with values a point and one for all.
std::vector<std::string> usdaSeeds() {
  StrandFile file;
  file.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}});
  file.strands.append(std::vector<glm::vec3>{{1, 0, 0}, {1, 1e-3f, 0}, {1, 2, 0}});
  file.defaultThickness = 1e-4f;
  file.transparency.assign(5, 0.5f);
  std::ostringstream still;
  writeUsda(still, file);
  file.up = UpAxis::ZBack;
  file.colours.assign(5, {1, 0.5f, 0.25f});
  std::ostringstream moving;
  {
    TextWriter out(moving);
    out << usdaHeader(0.01f, file.up, UsdaTimes{1, 2, 24});
    writeUsdaStill(out, file);
    out << "    point3f[] points.timeSamples = {\n        1: ";
    writeUsdaVectors(out, file.strands.points);
    out << ",\n        2: ";
    writeUsdaVectors(out, file.strands.points);
    out << ",\n    }\n    float3[] extent.timeSamples = {\n        1: ";
    writeUsdaExtent(out, file.strands.points, widestOf(file));
    out << ",\n    }\n" << usdaEnd();
  }
  return {sampleUsda(), still.str(), moving.str(), sampleUsdaScene(),
          "#usda 1.0\nclass \"c\" {}\nover \"o\" (\n  prepend references = @a.usd@</A>\n) {\n"
          "  variantSet \"v\" = { \"a\" { int x = 1 } }\n  custom rel r\n  reorder nameChildren = "
          "[\"a\"]\n}\ndef BasisCurves \"h\" {\n  token type = 'linear'\n  int[] "
          "curveVertexCounts.timeSamples = { 0: [1], 1: None }\n  point3f[] points = [(1, 2, 3)]; "
          "float a.connect = </b.c>\n}\n"};
}

// Somebody with a name for every part, in some order of channels; positions on every joint or on
// the hips alone; frames that jump at the start and flip in the middle.
std::string person(bool otherNames, bool positions, const char* neck = "0 15 0",
                   const char* leftHand = "25 0 0") {
  struct Part {
    const char *name, *otherName;
    int depth;
    const char* offset;
  };
  const Part kParts[] = {{"Hips", "hip", 0, "0 90 0"},
                         {"Spine", "abdomen", 1, "0 20 0"},
                         {"Chest", "chest", 2, "0 20 0"},
                         {"Neck", "neck", 3, neck},
                         {"Head", "head", 4, "0 10 0"},
                         {"LeftArm", "lShldr", 3, "15 10 0"},
                         {"LeftForeArm", "lForeArm", 4, "28 0 0"},
                         {"LeftHand", "lHand", 5, leftHand},
                         {"RightArm", "rShldr", 3, "-15 10 0"},
                         {"RightForeArm", "rForeArm", 4, "-28 0 0"},
                         {"RightHand", "rHand", 5, "-25 0 0"},
                         {"LeftUpLeg", "lThigh", 1, "10 0 0"},
                         {"LeftLeg", "lShin", 2, "0 -42 0"},
                         {"LeftFoot", "lFoot", 3, "0 -42 0"},
                         {"RightUpLeg", "rThigh", 1, "-10 0 0"},
                         {"RightLeg", "rShin", 2, "0 -42 0"},
                         {"RightFoot", "rFoot", 3, "0 -42 0"}};
  std::string bvh = "HIERARCHY\n", frame;
  int open = 0, channels = 0;
  const auto closeTo = [&](int depth) {
    for (; open > depth; --open) bvh += "}\n";
  };
  for (std::size_t i = 0; i < std::size(kParts); ++i) {
    const Part& part = kParts[i];
    closeTo(part.depth);
    bvh += text(i == 0 ? "ROOT " : "JOINT ", otherNames ? part.otherName : part.name, " {\nOFFSET ",
                part.offset, '\n');
    const bool moves = i == 0 || positions;
    bvh += moves ? "CHANNELS 6 Xposition Yposition Zposition " : "CHANNELS 3 ";
    bvh += otherNames ? "Xrotation Yrotation Zrotation\n" : "Zrotation Yrotation Xrotation\n";
    channels += moves ? 6 : 3;
    ++open;
    const bool leaf = i + 1 == std::size(kParts) || kParts[i + 1].depth <= part.depth;
    if (leaf) bvh += "End Site\n{\nOFFSET 0 -10 5\n}\n";
  }
  closeTo(0);
  constexpr int kFrames = 12;
  bvh += text("MOTION\nFrames: ", kFrames, "\nFrame Time: 0.0333\n");
  for (int f = 0; f < kFrames; ++f) {
    for (int c = 0; c < channels; ++c)
      bvh += text(f < 2               ? 0
                  : f == 6 && c == 20 ? 179
                                      : (f + c) % 7 * 5,
                  c + 1 < channels ? ' ' : '\n');
  }
  return bvh;
}

std::vector<std::string> objSeeds() {
  // A shared edge of three faces, a face turned over, one without area, corners from behind.
  return {sampleObj(),
          "\xEF\xBB\xBFv 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rg a\rusemtl b\r"
          "f 1 2 3\rf 1 2 4\rf 2 1 3\rf 1 1 2\rf -4 -3 -2 -1\rf 1 2 1 3\r"};
}

// As written; and groups, no layer but the scalp, parted hair.
std::vector<std::string> meshSeeds() {
  return {sampleHairMesh(), "g\rv 0 0 0\rv 0 0 1\rv 1 0 0\rf 1 2 3\r",
          "o a\nv 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nf 1 2 3\nf 3 2 4\n"
          "o b\nv 0 1 0\nv 0 1 1\nv 1 1 0\nv 1 1 0\nv 0 1 1\nv 1 1 1\nf 5 6 7\nf 8 9 10\n"};
}

// Every operation and option of scripts.
std::vector<std::string> scriptSeeds() {
  const std::string start = "scalp sphere 0.1 2 5 to 80\nselect a z > 0 or rim minus not x <= 0\n";
  return {
      sampleHairMeshScript(),
      start +
          "extrude all 0.02 towards 0 0 1 0.5 times 3\nselect b bundles 3..7 where ring = 1 and "
          "sector >= 0 and angle < 180 and tip-y > -1 and length < 1 and layers = 3 and sides > 3\n"
          "insert 2 a\nremove 3 all\nseparate a from b at 2\nweld a with b at 2\nseparate "
          "parting\nweld parting\nseparate-vertices b at 2\ndelete a times 2\n",
      start +
          "extrude all 0.02\nauto-place off\nmove all at 1..2 ramp 0 0 0.01\nscale a about 0 0 1 "
          "by 1 2 1\nrotate a at tip 30 about 0 0 0 axis 0 1 0\ngather a 0 0 0 0.1\nfall a "
          "0.5\nsmooth a 0.2 times 2\nkeep-out all 0.01\npin a\nunpin a at 1\nplace\nauto-place "
          "on\n",
      start +
          "drape all 3 length 0.1 lift 0.5 stiffness 0.1 clearance 0 volume 0\nsweep a 3 scale 0.5 "
          "twist 90 through 0 0 1 0 0 2\ncoil a 4 about 0 0 3 axis 0 1 0 turns 0.5 radius 0.1 rise "
          "0.1 scale 1 twist 0\n",
      "scalp sphere 0.1 1 4\nextrude all 0.1\nseparate-edge 1 0 1\nsubdivide loop flat\n",
      "scalp sphere 0.1 1 4\nextrude all 0.1\nsubdivide catmull-clark\ndivide-face 0 0 2\n"
      "divide-edge 1 0\n",
      "scalp head 1 4 parting 0.01 whorl -0.02\npull all 2 to 0 0.2 -0.15 axis 0 0 -1 radius 0.02 "
      "volume 0.01 clearance 0.002\ngroup strands 9 points 9 seed 3 per-square-metre 0 length-cut "
      "0.1 length-variation 0.2 clump 0.3 clump-size 7 curl-radius 0.01 curl-pitch 0.02 "
      "curl-from-root 0.25 noise 0.004 noise-length 0.05 frizz 0.002 frizz-length 0.006 "
      "frizz-share "
      "0.5\n",
      "scalp file a.obj\nextrude all 0.1\n"};
}

// What is typed with blanks, as lines.
std::string lines(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '\n');
  return words;
}

// Every option of every command at least once.
std::vector<std::string> optionSeeds() {
  static const std::string kSubject =
      " --hair a.tfx --head a.obj --head b.obj --scale 0.01 --up z-back --head-scale 0.1 --head-up "
      "x --prim a/b --points-per-strand 12 --strands 99 --points 9 "
      "--motion a.bvh --motion-scale 0.02 --motion-up z "
      "--head-joint Head --guides 50";
  static const std::string kPerformance =
      " --fps 30 --threads 2 --cells 64 --light 0,-1,0 --point 1,2,3,0.5,0.5,1 --light "
      "1,0,0,1,0,0 --wind -1,0,2 --no-shadow --no-self-collision --settle 0.5 --solver relaxation "
      "--solver-iterations 8";
  static const std::string kResults = " --profile a.csv --stats b.csv --hash";
  std::vector<std::string> seeds;
  for (const std::string& words : {
           std::string("hair --help"),
           std::string("dance --help"),
           std::string("hair info a.hair --scale 0.01 --up z"),
           std::string("hair convert a.data b.hair --strands 5 --points 7 --min-length 0.1 --up x"),
           std::string("hair convert a.usda b.####.ply --out-scale 0.01 --out-up z-back --frame 3"),
           std::string("hair simulate --cache a.usda"),
           std::string("hair lod --sizes 400,50 --importance 0.5 --fade 0.5 --sheet a.png"),
           "hair simulate --frames 3 --out a.hair --save-state a.state" + kSubject + kPerformance +
               kResults,
           std::string("hair simulate --style curly --still --frames=3"),
           "hair render --out a.png --frames 3 --yaw -90 --pitch 10 --distance 2 --width 64 "
           "--height 32 --side-by-side --show-guides --show-colliders --show-cells" +
               kSubject + kPerformance,
           std::string("hair render --style LONG --out a.exr"),
           std::string(
               "hair measure --style smooth --width 1e-4 --alpha 0.5 --light 0,-1,0 --point 0,2,0 "
               "--footprint 1e-3 --footprint 1e-2 --samples 9 --rays 8 --seed 7 --methods "
               "auto,shadow-map --max-error 0.1 --budget-ms 5 --repeats 2 --flicker-steps 0 "
               "--threads 1 --csv a.csv --html a.html"),
           std::string("hair measure --dump a.csv --methods quick"),
           "hair measure-motion --frames 9 --early 3 --reference 8 --substeps 1,2 --iterations 1,2 "
           "--relaxation 4,8 --plot a.svg "
           "--guide-counts 9,5 --csv a.csv" +
               kSubject + kPerformance,
           "hair plan --frames 20 --csv a.csv" + kSubject + kPerformance,
           "dance --headless --frames 9 --out a.mp4 --video-fps 24 --width 64 --height 32 --yaw 5 "
           "--pitch -5 --distance 3 --side-by-side" +
               kSubject + kPerformance + kResults,
           std::string("dance --style long --still"),
#ifdef HAIR_WITH_HAIR_MESH
           std::string("hair mesh apply a.hairmesh --out a.obj --hair a.hair"),
           std::string("hair mesh info a.obj"),
#endif
       })
    seeds.push_back(lines(words));
  return seeds;
}

}  // namespace

std::vector<FuzzSeeds> fuzzSeeds() {
  return {{"hair", hairSeeds()},
          {"tfx", tfxSeeds()},
          {"data", dataSeeds()},
          {"ply", plySeeds()},
          {"numpy", numpySeeds()},
          {"pbrt", {samplePbrt()}},
          {"lines", lineSeeds()},
          {"usda", usdaSeeds()},
          {"bvh", {sampleBvh(), person(false, false)}},
          // A neck that leaves sideways once gave a head that was turned nowhere, and a forearm
          // without length a hand that was nowhere.
          {"clip",
           {person(false, false), person(true, true), person(true, true, "41 0 0"),
            person(false, true, "0 15 0", "0 0 0"), sampleBvh()}},
          {"obj", objSeeds()},
          {"mesh", meshSeeds()},
          {"script", scriptSeeds()},
          {"state", sampleStates()},
          {"options", optionSeeds()}};
}

}  // namespace hair

#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/files/hair_file.h>

namespace hair {

/// A small valid file of each format, to read, cut and damage.

/// Every optional array, strands of 3, 1 and 2 points.
inline HairFile sampleHair() {
  HairFile hair;
  hair.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0.5f, 1, 0}, {0, 2, 1e-3f}});
  hair.strands.append(std::vector<glm::vec3>{{-1, 2, 3}});
  hair.strands.append(std::vector<glm::vec3>{{7, 8, 9}, {7, 8, 10}});
  hair.thickness = {1, 2, 3, 4, 5, 6};
  hair.transparency = {0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f};
  hair.colours.assign(6, {0.25f, 0.5f, 0.75f});
  hair.defaultThickness = 0.1f;
  hair.defaultTransparency = 0.2f;
  hair.defaultColour = {0.3f, 0.4f, 0.5f};
  hair.info = "three strands";
  return hair;
}

template <class T>
void putBytes(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Overwrites the bytes at an offset with those of the value.
template <class T>
std::string withBytes(std::string bytes, std::size_t offset, T value) {
  bytes.replace(offset, sizeof(T), reinterpret_cast<const char*>(&value), sizeof(T));
  return bytes;
}

/// Two strands of four points, root pinned, with strand UV.
inline std::string sampleTfx() {
  std::string bytes;
  putBytes(bytes, 4.0f);
  for (std::uint32_t word : {2u, 4u, 160u, 160u + 8 * 16, 0u, 0u, 0u}) putBytes(bytes, word);
  bytes.resize(160, '\0');
  for (int s = 0; s < 2; ++s)
    for (int p = 0; p < 4; ++p)
      for (float c : {s * 1.0f, p * 0.1f, -1.0f, p == 0 ? 0.0f : 1.0f}) putBytes(bytes, c);
  for (float c : {0.1f, 0.2f, 0.3f, 0.4f}) putBytes(bytes, c);
  return bytes;
}

/// Strands of 2, 0 and 1 points.
inline std::string sampleData() {
  std::string bytes;
  putBytes(bytes, std::int32_t{3});
  putBytes(bytes, std::int32_t{2});
  for (float c : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f}) putBytes(bytes, c);
  putBytes(bytes, std::int32_t{0});
  putBytes(bytes, std::int32_t{1});
  for (float c : {6.0f, 7.0f, 8.0f}) putBytes(bytes, c);
  return bytes;
}

/// Two branches, an end site, a joint without channels, one with a single channel; line ends,
/// blanks and braces as untidy as real files have them.
inline std::string sampleBvh() {
  return "HIERARCHY\r\nROOT hip\n{\r\n  OFFSET 0 0 0\n"
         "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
         "  JOINT left foot {\n    OFFSET +1 -2 3e-1\r\n    CHANNELS 1 Yrotation\n"
         "    End Site\n    {\n      OFFSET 0 -1 0\n    }\n  }\n"
         "  JOINT fixed\n  {\n    OFFSET 0 5 0\n    CHANNELS 0\n"
         "    JOINT head\n    {\n      OFFSET 0 1 0\n      CHANNELS 3 Zrotation Xrotation "
         "Yrotation\n"
         "    }\n  }\n}\n\n"
         "MOTION\r\nFrames:\t2\nFrame Time: 0.00833333\r\n"
         "1 2 3 4 5 6 7 8 9 10 \r\n\n-1\t-2 -3 -4 -5 -6 -7 -8 -9 -1e1\n";
}

/// A square and a triangle on its edge, corners in every spelling.
inline std::string sampleObj() {
  return "# sample\nv 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0 1.0\nvn 0 0 1\n"
         "f 1/1/1 2//1 3/2 4\nv 2 0.5 0\nf 3 2 -1\n";
}

/// Strands of three points, of bytes' colours, and of one; an element and a list besides.
inline std::string samplePlyText() {
  return "ply\r\nformat ascii 1.0\ncomment sample\nelement camera 1\nproperty list uchar int a\n"
         "property short b\nelement edge 2\nproperty int vertex2\nproperty int vertex1\n"
         "element vertex 4\nproperty float x\nproperty float32 y\nproperty double z\n"
         "property uchar red\nproperty uint8 green\nproperty uchar blue\n"
         "property float thickness\nend_header\n3 1 2 3 4\n1 0\n2 1\n0 0 0 255 0 51 .1\n"
         "0 1 0 255 0 51 .2\n0 2 0.5 255 0 51 .3\n7 8 9 1 2 3 .4\n";
}

/// Lines of three, one and two points, the first of them two lines long.
inline std::string sampleObjLines() {
  return "# libhair: metres, +Y up, +Z face\nv 0 0 0\nv 0 1 0\nv 0 2 0\nl 1 2 \\\n 3\nv 1 0 0\n"
         "p -1\nv 2 0 0 1\nl 4/1 5\n";
}

/// Two curves as somebody might write them: centimetres, Z up, comments, prims and dictionaries of
/// no interest, an animated and a constant array.
inline std::string sampleUsda() {
  return "#usda 1.0\n(\n  \"by hand\"\n  metersPerUnit = 0.01\n  upAxis = \"Z\"\n"
         "  timeCodesPerSecond = 25\n  startTimeCode = 1\n  subLayers = [@a.usd@]\n)\n"
         "def Xform \"World\" (\n  kind = \"group\"\n  customData = { string a = \"}\" }\n)\n{\n"
         "  uniform token[] xformOpOrder = []\n  def Mesh \"head\" { int[] a = [1, 2]\n"
         "    rel material:binding = </World/M> }\n  def BasisCurves \"hair\"\n  {\n"
         "    uniform token type = \"linear\" # straight\n    int[] curveVertexCounts = [2, 3,]\n"
         "    float[] widths (\n      interpolation = \"uniform\"\n    )\n"
         "    float[] widths.timeSamples = { 1: [1, 2], 2: [3, 4] }\n"
         "    color3f[] primvars:displayColor = [(0.5, 0.25, 1)] ( interpolation = \"constant\" )\n"
         "    point3f[] points.timeSamples = {\n"
         "      1: [(0, 0, 0), (0, 0, 1), (1, 0, 0), (1, 0, 1), (1, 0, 2)],\n"
         "      2.5: [(0, 0, 0), (0, 1, 1), (1, 0, 0), (1, 1, 1), (1, 2e0, -2)],\n    }\n"
         "    string note = '''it's a\n} note'''\n  }\n}\n";
}

/// Two squares on a scalp; the second's hair ends a layer earlier.
inline std::string sampleHairMesh() {
  return "# sample\no layer_0\nv 0 0 0\nv 0 0 1\nv 1 0 1\r\nv 1 0 0\nv 2 0 1\nv 2 0 0\n"
         "f 1 2 3 4\nf 4 3 5 6\no layer_1\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\nv 2 1 1\n"
         "v 2 1 0\nvn 0 1 0\nf 7//1 8//1 9 10\nf 10 9 11 12\no layer_2.001\nv 0 2 0\n"
         "v 0 2 1\nv 1 2 1\nv 1 2 0\nf -4 -3 -2 -1\n";
}

/// A scalp of three triangles, hair on two of them.
inline std::string sampleHairMeshScript() {
  return "scalp sphere 0.1 1 3\nselect a x > 0 # right\nextrude a .1\n\tmove a at tip 0 1 0\r"
         "group points 9\n";
}

/// Bytes from hexadecimal digits.
inline std::string bytesFromHex(std::string_view hex) {
  std::string bytes;
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(16 * digit(hex[i]) + digit(hex[i + 1]));
  return bytes;
}

/// Two strands of two points, as NumPy saves them.
inline std::string sampleNpy() {
  return bytesFromHex(
      "934e554d5059010046007b276465736372273a20273c6634272c2027666f727472616e5f6f72646572273a20"
      "46616c73652c20277368617065273a2028322c20322c2033292c207d202020202020200a000000000000803f"
      "0000004000004040000080400000a0400000c0400000e04000000041000010410000204100003041");
}

/// Points [5, 3] and the counts of two strands, as NumPy saves them; deflated or not.
inline std::string sampleNpz(bool packed) {
  if (packed)
    return bytesFromHex(
        "504b03041400000008000000000038e062685b0000008c0000000a000000706f696e74732e6e70799bec17ea"
        "1b10c9c8e0c650ad9e925a9c5ca46ea5a06e9366a2aea3a09e965f54529498179f5f94920a12774bcc294e05"
        "8a17672416a402f91aa63a0ac69a3a0ab50a70c0c500060d7640c29e81c101881b807801101fb02724070050"
        "4b030414000000080000000000d4cd5d324a000000580000000a000000636f756e74732e6e70799bec17ea1b"
        "10c9c8e0c650ad9e925a9c5ca46ea5a06e9369a2aea3a09e965f54529498179f5f94920a12774bcc294e058a"
        "17672416a402f91a463a9a3a0ab50a48808b89818181198801504b010214001400000008000000000038e062"
        "685b0000008c0000000a0000000000000000000000000000000000706f696e74732e6e7079504b0102140014"
        "000000080000000000d4cd5d324a000000580000000a0000000000000000000000000083000000636f756e74"
        "732e6e7079504b0506000000000200020070000000f50000000000");
  return bytesFromHex(
      "504b03041400000000000000000038e062688c0000008c0000000a000000706f696e74732e6e7079934e554d"
      "5059010046007b276465736372273a20273c6634272c2027666f727472616e5f6f72646572273a2046616c73"
      "652c20277368617065273a2028352c2033292c207d202020202020202020200a000000000000803e0000003f"
      "0000403f0000803f0000a03f0000c03f000000000000803e0000003f0000403f0000803f0000a03f0000c03f"
      "00000000504b030414000000000000000000d4cd5d3258000000580000000a000000636f756e74732e6e7079"
      "934e554d5059010046007b276465736372273a20273c6934272c2027666f727472616e5f6f72646572273a20"
      "46616c73652c20277368617065273a2028322c292c207d2020202020202020202020200a0200000003000000"
      "504b010214001400000000000000000038e062688c0000008c0000000a000000000000000000000000000000"
      "0000706f696e74732e6e7079504b0102140014000000000000000000d4cd5d3258000000580000000a000000"
      "00000000000000000000b4000000636f756e74732e6e7079504b050600000000020002007000000034010000"
      "0000");
}

/// Three strands: of two curves, of one, and a straight one of another basis and degree.
inline std::string samplePbrt() {
  return "LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [ 40 ]\nWorldBegin\n"
         "Material \"hair\" \"bool remap\" true # brown\nScale 2 2 2\n"
         "Shape \"curve\" \"string type\" [ \"flat\" ] \"point3 P\" [ 0 0 0 0 1 0 0 2 0 0 3 0 ]\n"
         "  \"float width0\" [ 0.2 ] \"float width1\" 0.1\n"
         "Shape \"curve\" \"point P\" [ 0 3 0 0 4 0 0 5 0 1 6 0 ]\nAttributeBegin\n"
         "Translate 1 0 0 Rotate 90 0 0 1\nConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1 ]\n"
         "Shape \"curve\" \"point P\" [ 0 0 0 0 1 0 0 2 0 ] \"integer degree\" 2\nAttributeEnd\n"
         "Shape \"curve\" \"string basis\" \"bspline\" \"point P\" [ 5 0 0 5 1 0 5 2 0 5 3 0 5 4 0 "
         "]\n"
         "Shape \"sphere\" \"float radius\" 3\n";
}

/// Two prims of curves in transforms that move, cubic and linear, in a variant, with indices.
inline std::string sampleUsdaScene() {
  return "#usda 1.0\n(\n  upAxis = \"Z\"\n)\ndef Xform \"A\" (\n  variants = { string v = \"b\" "
         "}\n)\n{\n"
         "  matrix4d xformOp:transform.timeSamples = { 1: ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, "
         "0), "
         "(1, 2, 3, 1)), 2: ((2, 0, 0, 0), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 1)) }\n"
         "  float3 xformOp:rotateXYZ = (10, 20, 30)\n  double3 xformOp:translate:p = (1, 0, 0)\n"
         "  quatf xformOp:orient = (1, 0, 0, 1)\n  uniform token[] xformOpOrder = "
         "[\"xformOp:transform\", "
         "\"xformOp:rotateXYZ\", \"!invert!xformOp:translate:p\", \"xformOp:orient\"]\n"
         "  def BasisCurves \"C\" {\n    uniform token basis = \"bspline\"\n    uniform token wrap "
         "= "
         "\"pinned\"\n    int[] curveVertexCounts = [3, 2]\n    point3f[] points = [(0, 0, 0), (0, "
         "1, 0), "
         "(1, 2, 0), (3, 0, 0), (3, 1, 0)]\n    float[] widths = [1, 2] (interpolation = "
         "\"uniform\")\n"
         "    color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] (interpolation = "
         "\"varying\")\n"
         "    int[] primvars:displayColor:indices = [0, 1, 0, 1, 1]\n  }\n  variantSet \"v\" = {\n"
         "    \"a\" { }\n    \"b\" {\n      def BasisCurves \"D\" {\n        uniform token type = "
         "\"linear\"\n"
         "        float3 xformOp:scale = (2, 2, 2)\n        uniform token[] xformOpOrder = "
         "[\"!resetXformStack!\", \"xformOp:scale\"]\n        int[] curveVertexCounts = [2]\n"
         "        point3f[] points = [(0, 0, 0), (0, 0, 1)]\n      }\n    }\n  }\n}\n";
}

/// A folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            text("hair_files_test_", std::hex, reinterpret_cast<std::uintptr_t>(this), "_", count++,
                 "_", std::random_device{}());
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The message of the Error that the call throws; "" where it throws none.
template <class Call>
std::string errorOf(Call&& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace hair

#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
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

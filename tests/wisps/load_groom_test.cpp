// One groom in every format, unit and axes, its head in the same or in others: what comes out is
// one.
#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/wisps/load_groom.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

const glm::vec3 kStands(0.2f, 1.5f, 0.1f);

TriangleMesh head() {
  static const TriangleMesh mesh = builtinHead().mesh;
  TriangleMesh moved = mesh;
  for (glm::vec3& p : moved.positions) p += kStands;
  return moved;
}

// Hair that stands on the scalp and falls, 8 points each.
StrandSet hairOnHead() {
  StrandSet strands;
  const TriangleMesh mesh = head();
  std::vector<glm::vec3> points(8);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 37) {
    if (scalpMask(mesh.positions[v] - kStands) < 0.5f) continue;
    for (std::size_t i = 0; i < 8; ++i) {
      const float t = 0.02f * static_cast<float>(i);
      points[i] = mesh.positions[v] + t * mesh.normals[v] - glm::vec3(0, 3 * t * t, 0);
    }
    strands.append(points);
  }
  return strands;
}

HeadFiles headIn(const ReadOptions& units) {
  HeadFiles files;
  files.meshes.push_back(head());
  convertUnitsBack(files.meshes[0].positions, units.scale, units.up);
  convertUnitsBack(files.meshes[0].normals, 1, units.up);
  return files;
}

void expectSame(const LoadedGroom& found, const LoadedGroom& expected) {
  ASSERT_EQ(found.groom.first, expected.groom.first);
  EXPECT_EQ(found.groom.parents, expected.groom.parents);
  float worst = 0;
  for (std::size_t i = 0; i < expected.groom.guidePoints.size(); ++i)
    worst =
        std::max(worst, glm::distance(found.groom.guidePoints[i], expected.groom.guidePoints[i]));
  EXPECT_LT(worst, 1e-5f);
  worst = 0;
  for (std::size_t v = 0; v < expected.head.head.mesh.positions.size(); ++v)
    worst = std::max(worst, glm::distance(found.head.head.mesh.positions.at(v),
                                          expected.head.head.mesh.positions[v]));
  EXPECT_LT(worst, 1e-5f);
}

TEST(LoadGroom, FromEveryFormatInEveryUnit) {
  const TemporaryFolder folder;
  const StrandSet strands = hairOnHead();
  ASSERT_GT(strands.strandCount(), 50u);
  writeStrands(folder / "expected.ply", strands);
  const BindSettings bind{.guides = 20};
  const LoadedGroom expected = loadGroom(folder / "expected.ply", {}, headIn({1, UpAxis::Y}), bind);
  for (const char* format : {"hair", "tfx", "data", "ply", "obj", "usda"})
    for (const float scale : {1.0f, 0.0254f})
      for (const UpAxis up : {UpAxis::ZBack, UpAxis::X}) {
        if (format == std::string("usda") && up == UpAxis::X) continue;
        SCOPED_TRACE(text(format, ' ', scale, ' ', wordOf(up)));
        const auto file = folder / text("a.", format);
        writeStrands(file, strands, {.scale = scale, .up = up});
        // The head follows what is said of the hair, or what the hair's file states.
        expectSame(loadGroom(file, {.read = {scale, up}}, headIn({scale, up}), bind), expected);
        if (format != std::string("tfx") && format != std::string("data"))
          expectSame(loadGroom(file, {}, headIn({scale, up}), bind), expected);
        // Or has units of its own.
        HeadFiles own = headIn({0.1f, UpAxis::Z});
        own.read = {0.1f, UpAxis::Z};
        expectSame(loadGroom(file, {.read = {scale, up}}, own, bind), expected);
      }
}

TEST(LoadGroom, SaysWhatItDid) {
  const TemporaryFolder folder;
  StrandSet strands = hairOnHead();
  strands.append(std::vector<glm::vec3>{{0, 1, 0}});
  writeStrands(folder / "a.ply", strands);
  const LoadedGroom loaded = loadGroom(folder / "a.ply", {.strands = 40}, {}, {.guides = 10});
  EXPECT_EQ(loaded.groom.strandCount(), 40u);
  EXPECT_EQ(loaded.groom.fibre.hairsPerStrand, 2500);
  std::string all;
  for (const std::string& note : loaded.notes) all += note + '\n';
  for (const char* words : {"a.ply: ", "1 m a unit, up axis y", "dropped 1 strands", "no --head",
                            "40 strands stand for 100000 hairs: 2500 each"})
    EXPECT_NE(all.find(words), std::string::npos) << all;
  EXPECT_NE(errorOf([&] {
              loadGroom(folder / "a.ply", {.read = {100, UpAxis::Y}});
            }).find("--scale: 0.01 times what it is"),
            std::string::npos);
}

}  // namespace
}  // namespace hair

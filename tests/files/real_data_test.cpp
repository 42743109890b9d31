#include <algorithm>

#include <gtest/gtest.h>

#include <libhair/files/bvh_file.h>
#include <libhair/files/hair_file.h>
#include <libhair/files/strand_file.h>
#include <libhair/files/tfx_file.h>
#ifdef HAIR_WITH_MODEL
#include <libhair/files/obj.h>
#endif

namespace hair {
namespace {

class RealData : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder / "hair"))
      GTEST_SKIP() << "real data not found at " << folder;
  }
  const std::filesystem::path folder = HAIR_DATA_DIR;
};

TEST_F(RealData, HairHasTheCountsOfItsReadme) {
  const HairFile straight = readHair(folder / "hair/straight.hair");
  EXPECT_EQ(straight.strands.strandCount(), 10000u);
  EXPECT_EQ(straight.strands.pointCount(), 160000u);
  EXPECT_EQ(straight.colours.size(), 160000u);
  EXPECT_TRUE(straight.thickness.empty());

  const TfxFile sintel = readTfx(folder / "hair/sintel.tfx");
  EXPECT_EQ(sintel.strands.strandCount(), 11400u);
  EXPECT_EQ(sintel.strands.pointCount(), 11400u * 16);
  for (std::size_t s = 0; s < sintel.strands.strandCount(); ++s)
    ASSERT_TRUE(sintel.pinned[sintel.strands.first[s]]) << s;

  EXPECT_EQ(readTfx(folder / "hair/sintel_guides.tfx").strands.strandCount(), 228u);
  const TfxFile ratboy = readTfx(folder / "hair/ratboy_mohawk.tfx");
  EXPECT_EQ(ratboy.strands.strandCount(), 2228u);
  EXPECT_EQ(ratboy.strandUv.size(), 2228u);
}

TEST_F(RealData, StrandsWithoutLengthAreNineOfRatboyAndNoneOfSintel) {
  StrandSet ratboy = readStrands(folder / "hair/ratboy_mohawk.tfx").strands;
  EXPECT_EQ(dropDegenerate(ratboy), 9u);
  StrandSet sintel = readStrands(folder / "hair/sintel.tfx").strands;
  EXPECT_EQ(dropDegenerate(sintel), 0u);
}

TEST_F(RealData, StraightHairSitsOnAHeadOfHumanSizeFaceForward) {
  const StrandSet hair = readStrands(folder / "hair/straight.hair").strands;
  Bounds roots;
  for (std::size_t s = 0; s < hair.strandCount(); ++s) roots.extend(hair.strand(s).front());
  EXPECT_GT(roots.size().x, 0.15f);  // ear to ear
  EXPECT_LT(roots.size().x, 0.20f);
  // Hair grows above and behind, not on the face: roots centre lies behind the ellipsoid's.
  EXPECT_LT(roots.centre().z, 0.00465f * 0.04f);
  // It hangs: tips are lower than roots.
  float drop = 0;
  for (std::size_t s = 0; s < hair.strandCount(); ++s)
    drop += hair.strand(s).front().y - hair.strand(s).back().y;
  EXPECT_GT(drop / static_cast<float>(hair.strandCount()), 0.05f);
}

TEST_F(RealData, DancesHaveTheCountsOfTheirReadme) {
  const std::tuple<const char*, std::size_t, double, const char*> clips[] = {
      {"jesse_dance", 1007, 100, "Head"}, {"05_06", 886, 120, "head"},
      {"05_11", 592, 120, "head"},        {"05_12", 1355, 120, "head"},
      {"05_20", 1096, 120, "head"},       {"13_39", 352, 120, "head"}};
  for (const auto& [name, frames, rate, head] : clips) {
    SCOPED_TRACE(name);
    const Bvh bvh = readBvh(folder / "motion" / (std::string(name) + ".bvh"));
    EXPECT_EQ(bvh.frameCount(), frames);
    EXPECT_NEAR(1 / bvh.frameTime, rate, 0.01);
    EXPECT_GE(bvh.find(head), 0);
    EXPECT_EQ(bvh.joints[0].channels.size(), 6u);
    // Centimetres, +Y up: the hips are about a metre above the ground.
    const auto y = std::find(bvh.joints[0].channels.begin(), bvh.joints[0].channels.end(),
                             Bvh::Channel::Yposition);
    const float height =
        bvh.frame(10)[static_cast<std::size_t>(y - bvh.joints[0].channels.begin())];
    EXPECT_GT(height, 60);
    EXPECT_LT(height, 130);
  }
}

#ifdef HAIR_WITH_MODEL

TEST_F(RealData, HeadsLoadWhole) {
  const std::tuple<const char*, std::size_t, std::size_t> heads[] = {
      {"sintel", 3046, 5952}, {"sintel-collider", 341, 678}, {"sintel-eyes", 708, 1408}};
  for (const auto& [name, vertices, faces] : heads) {
    SCOPED_TRACE(name);
    ObjReport report;
    const TriangleMesh mesh = readObj(folder / "head" / (std::string(name) + ".obj"), &report);
    EXPECT_EQ(report.faces, faces);
    EXPECT_EQ(report.dropped, 0u);
    EXPECT_EQ(mesh.triangles.size(), faces);
    EXPECT_GE(mesh.positions.size(), vertices);
    EXPECT_LE(mesh.positions.size(), vertices + 3 * report.split);
    EXPECT_LE(report.split, faces / 100);
  }
}

// Distance to the nearest corner or centre of a triangle: enough to tell that two files share a
// space.
TEST_F(RealData, RootsOfSintelLieOnHerHead) {
  const TriangleMesh head = readObj(folder / "head/sintel.obj");
  const StrandSet hair = readStrands(folder / "hair/sintel.tfx").strands;
  std::vector<glm::vec3> samples = head.positions;
  for (glm::uvec3 t : head.triangles)
    samples.push_back((head.positions[t.x] + head.positions[t.y] + head.positions[t.z]) / 3.0f);
  std::vector<float> distances;
  for (std::size_t s = 0; s < hair.strandCount(); s += 100) {
    float nearest = INFINITY;
    for (glm::vec3 p : samples) nearest = std::min(nearest, glm::distance(p, hair.strand(s)[0]));
    distances.push_back(nearest);
  }
  std::sort(distances.begin(), distances.end());
  EXPECT_LT(distances[distances.size() / 2], 0.008f);
  EXPECT_LT(distances.back(), 0.02f);
}

#endif

}  // namespace
}  // namespace hair

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/files/obj.h>
#include <libhair/files/strand_file.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/head.h>

namespace hair {
namespace {

std::vector<glm::vec3> rootsOf(const StrandSet& strands) {
  std::vector<glm::vec3> roots;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) roots.push_back(strands.strand(s)[0]);
  return roots;
}

std::vector<glm::vec3> builtinRoots() {
  std::vector<glm::vec3> roots;
  for (glm::vec3 p : builtinHead().mesh.positions)
    if (scalpMask(p) > 0.5f) roots.push_back(p);
  return roots;
}

float median(std::vector<float> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

TEST(HeadFit, ABustThatWasMovedIsMovedBack) {
  const glm::vec3 moved(0.3f, 1.5f, -0.2f);
  TriangleMesh bust = builtinHead().mesh;
  for (glm::vec3& p : bust.positions) p += moved;
  std::vector<glm::vec3> roots = builtinRoots();
  for (glm::vec3& p : roots) p += moved;
  EXPECT_LT(glm::length(placeHead(bust, roots).translation + moved), 1e-4f);
  EXPECT_LT(glm::length(placeHead(bust, {}).translation + moved), 1e-4f);
}

TEST(HeadFit, AHeadThatWasScaledIsFound) {
  const glm::vec3 scale(1.25f, 1.1f, 1.2f), moved(0.1f, -0.4f, 0.2f);
  std::vector<glm::vec3> roots = builtinRoots();
  for (glm::vec3& p : roots) p = scale * p + moved;
  const HeadFit fit = fitHeadToRoots(roots);
  EXPECT_LT(fit.residual, 5e-4f);
  const MeshSdf sdf(fit.head.mesh, 0.005f, 0.03f);
  for (glm::vec3 p : roots) ASSERT_NEAR(sdf.distance(fit.headFromHair.point(p)), 0, 2e-3f);
}

TEST(HeadFit, TooFewRootsAndWrongUnitsAreErrors) {
  EXPECT_THROW(fitHeadToRoots(std::vector<glm::vec3>(3)), Error);
  std::vector<glm::vec3> roots = builtinRoots();
  for (glm::vec3& p : roots) p *= 100;  // centimetres taken for metres
  EXPECT_THROW(fitHeadToRoots(roots), Error);
}

TEST(HeadFit, SintelsSkullComesToLieWhereOursIs) {
  const std::filesystem::path data = HAIR_DATA_DIR;
  if (!std::filesystem::exists(data / "head/sintel.obj"))
    GTEST_SKIP() << "real data not found at " << data;
  const TriangleMesh mesh = readObj(data / "head/sintel.obj");
  const auto roots = rootsOf(readStrands(data / "hair/sintel.tfx").strands);
  const RigidTransform headFromModel = placeHead(mesh, roots);
  TriangleMesh placed = mesh;
  for (glm::vec3& p : placed.positions) p = headFromModel.point(p);
  const float crown = bounds(placed.positions).upper.y;
  EXPECT_NEAR(crown, 0.206f, 0.03f);

  // Roots lie on the bust, the middle of the skull is inside, the air around is outside, and the
  // open bottom is closed.
  const MeshSdf sdf(placed, 0.005f, 0.05f);
  std::vector<float> distance;
  for (glm::vec3 p : roots) distance.push_back(std::abs(sdf.distance(headFromModel.point(p))));
  EXPECT_LT(median(distance), 6e-4f);
  EXPECT_LT(sdf.distance({0, 0.1f, 0}), -0.05f);
  EXPECT_LT(sdf.distance({0, -0.05f, -0.01f}), -0.01f);
  for (glm::vec3 p : {glm::vec3(0.12f, 0.1f, 0), glm::vec3(0, 0.1f, -0.14f), glm::vec3(0, 0, 0.13f),
                      glm::vec3(0, bounds(placed.positions).lower.y - 0.01f, 0)})
    EXPECT_GT(sdf.distance(p), 0.004f) << p.x << " " << p.y << " " << p.z;
}

TEST(HeadFit, StraightHairGetsAHead) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/straight.hair";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  const auto roots = rootsOf(readStrands(file).strands);
  const HeadFit fit = fitHeadToRoots(roots);
  EXPECT_LT(fit.residual, 4e-3f);
  const MeshSdf sdf(fit.head.mesh, 0.005f, 0.03f);
  std::vector<float> distance;
  for (glm::vec3 p : roots) distance.push_back(std::abs(sdf.distance(fit.headFromHair.point(p))));
  EXPECT_LT(median(distance), 3e-3f);
}

}  // namespace
}  // namespace hair

#include <set>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/truth.h>

#include "hair_samples.h"

namespace hair {
namespace {

TEST(SamplePoints, AreOfDifferentStrandsAsLongAsThereAreEnough) {
  const StrandSet strands = test::randomStrands(100, 8, 0.01f, 0.3f, 0.05f);
  for (std::size_t count : {1u, 50u, 100u}) {
    const auto points = chooseSamplePoints(strands, count, 3);
    ASSERT_EQ(points.size(), count);
    std::set<std::uint32_t> seen;
    for (const SamplePoint& p : points) {
      EXPECT_TRUE(seen.insert(p.strand).second);
      EXPECT_GT(p.point, strands.first[p.strand]);  // no root
      EXPECT_LT(p.point, strands.first[p.strand + 1]);
      EXPECT_EQ(p.position, strands.points[p.point]);
    }
  }
  // Then two of each, and no point twice.
  std::vector<int> ofStrand(100, 0);
  std::set<std::uint32_t> seen;
  for (const SamplePoint& p : chooseSamplePoints(strands, 200, 3)) {
    ++ofStrand[p.strand];
    EXPECT_TRUE(seen.insert(p.point).second);
  }
  EXPECT_EQ(ofStrand, std::vector<int>(100, 2));
}

TEST(SamplePoints, AreAllWhereThereAreFewer) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>(3));
  strands.append(std::vector<glm::vec3>(1));  // only a root
  strands.append(std::vector<glm::vec3>(2));
  strands.append({});
  const auto points = chooseSamplePoints(strands, 1000, 1);
  std::vector<std::uint32_t> which;
  for (const SamplePoint& p : points) which.push_back(p.point);
  EXPECT_EQ(which, (std::vector<std::uint32_t>{1, 2, 5}));
  EXPECT_TRUE(chooseSamplePoints(strands, 0, 1).empty());
}

TEST(SamplePoints, FollowTheSeed) {
  const StrandSet strands = test::randomStrands(1000, 8, 0.01f, 0.3f, 0.05f);
  const auto which = [&](std::uint32_t seed) {
    std::vector<std::uint32_t> points;
    for (const SamplePoint& p : chooseSamplePoints(strands, 200, seed)) points.push_back(p.point);
    return points;
  };
  EXPECT_EQ(which(1), which(1));
  EXPECT_NE(which(1), which(2));
}

// One point of each of 3,500 strands, seven places behind the root on every strand: all equally
// likely.
TEST(SamplePoints, ArePlacedEvenlyAlongStrands) {
  const StrandSet strands = test::randomStrands(5000, 8, 0.01f, 0.3f, 0.05f);
  double ofPlace[8] = {};
  for (const SamplePoint& p : chooseSamplePoints(strands, 3500, 9))
    ofPlace[p.point - strands.first[p.strand]] += 1;
  EXPECT_EQ(ofPlace[0], 0);
  double chiSquare = 0;
  for (int k = 1; k < 8; ++k) chiSquare += (ofPlace[k] - 500) * (ofPlace[k] - 500) / 500;
  EXPECT_LT(chiSquare, 22.5);  // six degrees of freedom: one in a thousand is larger
}

TEST(SamplePoints, BadStrandsAreErrors) {
  const std::vector<glm::vec3> points(3);
  const std::vector<std::uint32_t> first{0, 2};
  EXPECT_THROW(chooseSamplePoints({points, first}, 1, 1), Error);
}

}  // namespace
}  // namespace hair

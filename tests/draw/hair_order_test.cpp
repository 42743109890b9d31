#include <apps/draw/hair_order.h>

#include <algorithm>

#include <gtest/gtest.h>

using namespace hair;
using draw::HairOrder;

namespace {

StrandSet randomStrands() {
  StrandSet strands;
  std::uint32_t seed = 1;
  const auto number = [&] {
    seed = seed * 1664525u + 1013904223u;
    return float(seed >> 8) / 16777216.0f;
  };
  for (std::size_t length : {5, 2, 1, 0, 9, 3}) {
    std::vector<glm::vec3> points(length);
    for (glm::vec3& p : points) p = {number(), number(), number()};
    strands.append(points);
  }
  return strands;
}

}  // namespace

TEST(HairOrder, DrawsEverySegmentOnceFromFarToNear) {
  const StrandSet strands = randomStrands();
  const glm::vec3 view = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  HairOrder order;
  ASSERT_TRUE(order.setTopology(strands.first));
  ASSERT_EQ(order.segmentCount(), strands.segmentCount());
  order.sort(strands.points, view);
  std::vector<glm::uvec2> lines;
  order.writeLines(lines);
  std::vector<int> drawn(strands.pointCount(), 0);
  float before = INFINITY;
  for (const glm::uvec2& line : lines) {
    EXPECT_EQ(line.y, line.x + 1);
    ++drawn[line.x];
    const float depth = glm::dot(strands.points[line.x] + strands.points[line.y], view);
    EXPECT_LE(depth, before + 1e-4f) << "a nearer segment is drawn before a farther one";
    before = depth;
  }
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    for (std::uint32_t i = strands.first[s]; i < strands.first[s + 1]; ++i) {
      EXPECT_EQ(drawn[i], i + 1 < strands.first[s + 1]) << "segment from point " << i;
    }
  }
}

TEST(HairOrder, RibbonsLeanOnNeighboursOfTheirOwnStrandOnly) {
  const StrandSet strands = randomStrands();
  HairOrder order;
  order.setTopology(strands.first);
  for (const glm::uvec4& s : order.all()) {
    const auto strandOf = [&](std::uint32_t point) {
      return std::upper_bound(strands.first.begin(), strands.first.end(), point) -
             strands.first.begin();
    };
    EXPECT_EQ(strandOf(s.x), strandOf(s.y));
    EXPECT_EQ(strandOf(s.y), strandOf(s.z));
    EXPECT_EQ(strandOf(s.z), strandOf(s.w));
    EXPECT_LE(s.y - s.x, 1u);
    EXPECT_LE(s.w - s.z, 1u);
  }
}

TEST(HairOrder, TopologyIsTakenAnewOnlyWhenItChanges) {
  const StrandSet strands = randomStrands();
  HairOrder order;
  EXPECT_TRUE(order.setTopology(strands.first));
  EXPECT_FALSE(order.setTopology(strands.first));
  const std::uint32_t other[] = {0, 3};
  EXPECT_TRUE(order.setTopology(other));
  EXPECT_EQ(order.segmentCount(), 2u);
}

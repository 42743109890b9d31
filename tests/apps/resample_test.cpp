#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/model/resample.h>

namespace hair {
namespace {

StrandSet curls(std::uint32_t count) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < count; ++s) {
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 2 + s % 30; ++i) {
      const float a = 0.3f * static_cast<float>(i) + uniform(s, i);
      points.emplace_back(std::cos(a), 0.1f * static_cast<float>(i), std::sin(a));
    }
    strands.append(points);
  }
  return strands;
}

std::vector<std::uint32_t> all(const StrandSet& strands) {
  return chooseStrands(strands.strandCount(), strands.strandCount());
}

TEST(Resample, KeepingThePointsKeepsTheirBits) {
  const StrandSet strands = curls(50);
  const ResamplePlan plan = planResampling(strands, all(strands), 0);
  EXPECT_EQ(resample(plan, strands.points), strands.points);
  EXPECT_EQ(plan.first, strands.first);
}

TEST(Resample, RootAndTipStayAndSpacingAlongTheLengthIsEven) {
  const StrandSet strands = curls(50);
  for (std::size_t count : {2u, 3u, 16u, 100u}) {
    const ResamplePlan plan = planResampling(strands, all(strands), count);
    const StrandSet result{resample(plan, strands.points), plan.first};
    for (std::size_t s = 0; s < strands.strandCount(); ++s) {
      const auto was = strands.strand(s);
      const auto is = std::as_const(result).strand(s);
      ASSERT_EQ(is.size(), count);
      EXPECT_EQ(is.front(), was.front());
      EXPECT_EQ(is.back(), was.back());
      // Where each new point lies along the old strand.
      for (std::size_t k = 0; k < count; ++k) {
        const auto [index, t] = plan.samples[s * count + k];
        const auto upTo = was.first(index - strands.first[s] + 1);
        const float at =
            arcLength(upTo) + (t > 0 ? t * glm::distance(upTo.back(), was[upTo.size()]) : 0);
        const float want = arcLength(was) * static_cast<float>(k) / static_cast<float>(count - 1);
        EXPECT_NEAR(at, want, 1e-5f * arcLength(was)) << s << ' ' << k;
      }
    }
  }
}

TEST(Resample, SegmentsWithoutLengthAndSinglePointsAreHarmless) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  strands.append(std::vector<glm::vec3>{{5, 5, 5}});
  strands.append(std::vector<glm::vec3>{{3, 3, 3}, {3, 3, 3}});
  strands.append({});
  const ResamplePlan plan = planResampling(strands, all(strands), 5);
  EXPECT_EQ(plan.first, (std::vector<std::uint32_t>{0, 5, 10, 15, 15}));
  const auto points = resample(plan, strands.points);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LT(glm::distance(points[k], glm::vec3(0.5f * static_cast<float>(k), 0, 0)), 1e-6f);
    EXPECT_EQ(points[5 + k], glm::vec3(5));
    EXPECT_EQ(points[10 + k], glm::vec3(3));
  }
}

TEST(ChooseStrands, SmallerChoicesLieInsideLargerOnesInOrder) {
  const auto large = chooseStrands(1000, 300), small = chooseStrands(1000, 100);
  EXPECT_EQ(large.size(), 300u);
  EXPECT_TRUE(std::is_sorted(large.begin(), large.end()));
  EXPECT_TRUE(std::includes(large.begin(), large.end(), small.begin(), small.end()));
  EXPECT_EQ(std::adjacent_find(large.begin(), large.end()), large.end());
  // Spread over all of them, not the first ones.
  EXPECT_GT(std::count_if(small.begin(), small.end(), [](auto s) { return s >= 500; }), 30);
  EXPECT_EQ(chooseStrands(5, 9).size(), 5u);
}

}  // namespace
}  // namespace hair

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/files/strand_file.h>
#include <libhair/wisps/bind.h>
#include <libhair/wisps/guide_curves.h>
#include <libhair/wisps/literal.h>
#include <libhair/wisps/wisps.h>

namespace hair {
namespace {

// Wavy strands of different lengths and point counts on a small dome.
StrandSet dome(std::uint32_t count) {
  StrandSet strands;
  for (std::uint32_t s = 0; s < count; ++s) {
    const float a = 6.2831853f * uniform(s, 0), r = 0.08f * std::sqrt(uniform(s, 1));
    const glm::vec3 root(r * std::cos(a), std::sqrt(0.01f - r * r), r * std::sin(a));
    const auto n = 6 + static_cast<std::uint32_t>(20 * uniform(s, 2));
    const float length = 0.1f + 0.2f * uniform(s, 3), wave = 9 * uniform(s, 4);
    std::vector<glm::vec3> points;
    for (std::uint32_t k = 0; k < n; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(n - 1);
      points.push_back(root * (1 + 10 * length * t) +
                       0.01f * t * glm::vec3(std::cos(wave * t), std::sin(wave * t), -t));
    }
    strands.append(points);
  }
  return strands;
}

float largestDifference(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  float worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, glm::distance(a[i], b[i]));
  return worst;
}

TEST(Wisps, ABoundGroomReproducesItselfAtRest) {
  const StrandSet strands = dome(300);
  const Groom groom = bindGroom(strands, {40, 12, 0.5f});
  const GuideStrands guides(groom, {});
  Wisps wisps(groom, guides);
  interpolateWisps(guides, {}, wisps);
  ASSERT_EQ(wisps.points.size(), strands.points.size());
  EXPECT_LT(largestDifference(wisps.points, strands.points),
            1e-5f * glm::length(bounds(strands.points).size()));
}

TEST(Wisps, ARealGroomReproducesItselfAtRest) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/sintel.tfx";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  const StrandFile loaded = readStrands(file);
  const Groom groom = bindGroom(loaded.strands);
  const GuideStrands guides(groom, {});
  const Wisps wisps(groom, guides);
  EXPECT_LT(largestDifference(wisps.points, loaded.strands.points),
            1e-5f * glm::length(bounds(loaded.strands.points).size()));
}

TEST(Wisps, DrawnStrandsMoveRigidlyWithAHeadThatCarriesItsGuides) {
  const StrandSet strands = dome(100);
  const Groom groom = bindGroom(strands, {20, 12, 0.5f});
  const RigidTransform head{glm::angleAxis(2.1f, glm::normalize(glm::vec3(1, 2, -1))), {3, -1, 2}};
  const GuideStrands guides(groom, {}, head);
  Wisps wisps(groom, guides);
  interpolateWisps(guides, {}, wisps);
  std::vector<glm::vec3> expected;
  for (glm::vec3 p : strands.points) expected.push_back(head.point(p));
  EXPECT_LT(largestDifference(wisps.points, expected), 1e-5f);
}

TEST(Wisps, CurvesPassThroughGuidePointsAndStraightGuidesStayStraight) {
  Groom groom;
  groom.pointsPerGuide = 5;
  for (int i = 0; i < 5; ++i) groom.guidePoints.emplace_back(0.1f * static_cast<float>(i), 0, 0);
  for (int i = 0; i < 5; ++i)
    groom.guidePoints.emplace_back(0.1f * std::cos(static_cast<float>(i)),
                                   0.1f * std::sin(static_cast<float>(i)), 1);
  const GuideStrands guides(groom, {});
  GuideCurves curves(guides, 9);
  sampleGuides(guides, curves);
  for (std::uint32_t k = 0; k < 9; ++k)
    EXPECT_LT(glm::distance(curves.point(0, k), glm::vec3(0.05f * static_cast<float>(k), 0, 0)),
              1e-7f);
  for (std::uint32_t i = 0; i < 5; ++i)
    EXPECT_LT(glm::distance(curves.point(1, 2 * i), groom.guidePoints[5 + i]), 1e-7f);
}

TEST(Wisps, FramesStayOrthonormalAndDoNotTwist) {
  // Along a plane curve the carried normal keeps its angle to the plane.
  Groom groom;
  groom.pointsPerGuide = 24;
  for (int i = 0; i < 24; ++i) {
    const float a = 0.2f * static_cast<float>(i);
    groom.guidePoints.emplace_back(0.1f * std::cos(a), 0.1f * std::sin(a), 0);
  }
  const GuideStrands guides(groom, {});
  GuideCurves curves(guides, 100);
  sampleGuides(guides, curves);
  const auto first = curves.frame(0, 0);
  for (std::uint32_t k = 0; k < curves.samples; ++k) {
    const auto f = curves.frame(0, k);
    EXPECT_NEAR(glm::dot(f.normal, f.tangent), 0, 1e-5f);
    EXPECT_NEAR(glm::length(f.normal), 1, 1e-5f);
    EXPECT_NEAR(f.normal.z, first.normal.z, 1e-3f);
  }
}

TEST(Wisps, ATipIsKeptOutOfAColliderThatNothingElseOfItsStrandMeets) {
  for (const std::uint32_t n : {9u, 16u, 17u, 33u}) {
    Groom groom;
    groom.pointsPerGuide = 12;
    for (const float x : {-0.05f, 0.05f})
      for (int i = 0; i < 12; ++i)
        groom.guidePoints.emplace_back(x, 0.3f - 0.6f * static_cast<float>(i) / 11, 0);
    groom.parents = {{0, 1, 0}};
    groom.weights = {{0.6f, 0.4f, 0}};
    groom.first = {0, n};
    const GuideStrands guides(groom, {});
    Wisps wisps(groom, guides);
    const Capsule ball{{0, -0.3f, 0}, {0, -0.3f, 0}, 0.015f};
    EXPECT_LT(distanceAndGradient(ball, wisps.points[n - 1]).w, -0.004f) << "nothing to avoid";
    EXPECT_GT(distanceAndGradient(ball, wisps.points[n - 2]).w, 0.003f);
    interpolateWisps(guides, {{}, {}, {&ball, 1}, {&ball, 1}, nullptr}, wisps);
    EXPECT_GE(distanceAndGradient(ball, wisps.points[n - 1]).w, -1e-6f) << n << " points";
  }
}

TEST(Wisps, SameBitsForAnyThreadCount) {
  std::vector<std::vector<glm::vec3>> results;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const Groom groom = bindGroom(dome(200), {30, 12, 0.5f});
    const GuideStrands guides(groom, {});
    results.push_back(Wisps(groom, guides).points);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

// Strands of the given numbers of points, again and again, on six guides that hang past a ball.
struct Hanging {
  Groom groom;
  std::vector<Capsule> body{{{0, 0, 0}, {0, 0, 0}, 0.08f},
                            {{0.05f, -0.2f, -0.1f}, {-0.02f, -0.25f, 0.1f}, 0.04f}};
  ColliderState colliders{{}, {}, body, body, nullptr};

  explicit Hanging(std::vector<std::uint32_t> counts) {
    groom.pointsPerGuide = 12;
    for (std::uint32_t g = 0; g < 6; ++g)
      for (int i = 0; i < 12; ++i) {
        const float t = static_cast<float>(i) / 11, a = 1.05f * static_cast<float>(g);
        const float r = 0.03f + 0.08f * std::sin(3.14159265f * t);
        groom.guidePoints.emplace_back(r * std::cos(a), 0.3f - 0.6f * t, r * std::sin(a));
      }
    for (std::uint32_t s = 0; s < 90; ++s) {
      const std::uint32_t n = counts[s % counts.size()];
      const float y = 0.5f * uniform(s, 1), z = 0.3f * uniform(s, 2);
      groom.parents.emplace_back(s % 6, (s + 1 + s / 6) % 6, (s + 3) % 6);
      groom.weights.emplace_back(1 - y - z, y, z);
      for (std::uint32_t k = 0; k < n; ++k)
        groom.offsets.push_back(0.01f * glm::vec3(uniform(s, k, 1), uniform(s, k, 2), 0));
      groom.first.push_back(groom.first.back() + n);
    }
  }
};

const std::vector<std::vector<std::uint32_t>> kCounts = {{2},  {15}, {16},
                                                         {17}, {33}, {2, 15, 16, 17, 31, 33, 40}};

TEST(Wisps, AreWhatThePlainFormulaSays) {
  for (const auto& counts : kCounts) {
    const Hanging hanging(counts);
    const GuideStrands guides(hanging.groom, {});
    Wisps wisps(hanging.groom, guides);
    const auto free = wisps.points;
    interpolateWisps(guides, hanging.colliders, wisps);
    if (counts.back() > 2) {
      EXPECT_GT(largestDifference(wisps.points, free), 0.01f) << "nothing is avoided";
    }
    const auto expected = literal::interpolateWisps(hanging.groom, guides, hanging.colliders);
    for (std::size_t p = 0; p < expected.size(); ++p)
      ASSERT_LT(glm::distance(glm::dvec3(wisps.points[p]), expected[p]), 2e-6)
          << counts.front() << " points, point " << p;
    for (std::size_t s = 0; s < hanging.groom.strandCount(); ++s)
      for (std::size_t k = hanging.groom.first[s] + 1; k < hanging.groom.first[s + 1]; ++k)
        for (const Capsule& c : hanging.body)
          ASSERT_GE(distanceAndGradient(c, wisps.points[k]).w, -1e-6f);
  }
}

TEST(Wisps, SameBitsOnEveryInstructionSetForAnyThreadCountAndForRanges) {
  const Hanging hanging(kCounts.back());
  std::vector<glm::vec3> best;
  for (const std::string_view name : instructionSets())
    for (int threads : {1, 2, 7}) {
      const InstructionSetLimit set(name);
      const ThreadLimit limit(threads);
      const GuideStrands guides(hanging.groom, {});
      Wisps wisps(hanging.groom, guides);
      interpolateWisps(guides, hanging.colliders, wisps);
      if (best.empty()) best = wisps.points;
      EXPECT_EQ(wisps.points, best) << name << ", " << threads << " threads";
      std::fill(wisps.points.begin(), wisps.points.end(), glm::vec3(0));
      prepareWisps(guides, hanging.colliders, wisps);
      for (std::size_t s = 0; s < 90; s += 9) drawWisps(s, s + 9, wisps);
      EXPECT_EQ(wisps.points, best) << name << ", in ranges";
    }
}

TEST(Wisps, LongStrandsFollowTheirCurvesToTheTip) {
  const Hanging hanging({70'000});
  Groom groom = hanging.groom;
  groom.first.resize(2), groom.parents.resize(1), groom.weights.resize(1), groom.offsets.clear();
  const GuideStrands guides(groom, {});
  const Wisps wisps(groom, guides);
  for (std::uint32_t k : {0u, 1u, 46'341u, 69'999u}) EXPECT_EQ(wisps.sampleOf(k, 70'000), k);
}

TEST(Wisps, AGroomWhoseArraysDisagreeIsRefused) {
  const Groom good = bindGroom(dome(20), {6, 8, 0.5f});
  const GuideStrands guides(good, {});
  const auto refused = [&](auto change) {
    Groom groom = good;
    change(groom);
    EXPECT_THROW(Wisps(groom, guides), Error);
  };
  refused([](Groom& g) { g.weights.pop_back(); });
  refused([](Groom& g) { g.offsets.pop_back(); });
  refused([](Groom& g) { g.parents[3].y = 6; });
  refused([](Groom& g) { g.weights[3].x += 0.1f; });
  refused([](Groom& g) { g.first[4] = g.first[3] + 1; });
}

}  // namespace
}  // namespace hair

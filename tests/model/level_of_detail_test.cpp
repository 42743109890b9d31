// Laws of the levels themselves; tests/frame/level_test.cpp has those of hair drawn at them.
#include <libhair/model/level_of_detail.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/model/head.h>
#include <libhair/model/styles.h>

namespace hair {
namespace {

const Groom& curls() {
  static const Groom groom = [] {
    const MeshSdf head(builtinHead().mesh);
    StyleSettings style = styleSettings(Style::Curly);
    style.strands = 2000;
    return makeGroom(style, head);
  }();
  return groom;
}

const GroomDetail& detail() {
  static const GroomDetail made(curls());
  return made;
}

TEST(LevelOfDetail, AHeadThatFillsTheScreenIsDrawnWhole) {
  const LevelOfDetail level = levelFor(detail(), 1e5f);
  EXPECT_EQ(level.strands, 1);
  EXPECT_EQ(level.points, 1);
  EXPECT_TRUE(level.drawsAll());
  for (const float rank : detail().rank) ASSERT_EQ(level.weightOf(rank), 1);
  EXPECT_EQ(level.segmentsOf(60, 0), 60u);
}

TEST(LevelOfDetail, GrowsWithSizeAndImportance) {
  LevelOfDetail before = levelFor(detail(), 2);
  for (float pixels = 2; pixels < 5000; pixels *= 1.03f) {
    const LevelOfDetail level = levelFor(detail(), pixels);
    ASSERT_GE(level.strands, before.strands);
    ASSERT_GE(level.points, before.points);
    ASSERT_LE(level.cellSize, before.cellSize);
    before = level;
    LevelOfDetail lesser = levelFor(detail(), pixels, 0.01f);
    for (float importance = 0.02f; importance < 1; importance += 0.02f) {
      const LevelOfDetail l = levelFor(detail(), pixels, importance);
      ASSERT_GE(l.strands, lesser.strands);
      ASSERT_GE(l.points, lesser.points);
      ASSERT_LE(l.cellSize, lesser.cellSize);
      lesser = l;
    }
  }
}

TEST(LevelOfDetail, HalfAsImportantIsHalfAsLarge) {
  for (const float pixels : {20.0f, 100.0f, 800.0f})
    EXPECT_EQ(levelFor(detail(), pixels, 0.5f), levelFor(detail(), 0.5f * pixels));
}

TEST(LevelOfDetail, ChangesByNoMoreThanTheSizeDoes) {
  for (float pixels = 4; pixels < 3000; pixels *= 1.01f) {
    const LevelOfDetail a = levelFor(detail(), pixels), b = levelFor(detail(), 1.001f * pixels);
    ASSERT_NEAR(b.strands / a.strands, 1, 0.0011f);
    ASSERT_NEAR(b.points / a.points, 1, 0.01f) << pixels;
    ASSERT_NEAR(b.cellSize / a.cellSize, 1, 0.0011f);
  }
}

TEST(LevelOfDetail, StrandsOfALowerLevelAreDrawnAtAllHigherOnes) {
  LevelOfDetail level;
  std::vector<float> before(detail().strandCount(), 0);
  for (level.strands = 0.01f; level.strands <= 1; level.strands *= 1.1f)
    for (std::size_t s = 0; s < before.size(); ++s) {
      const float weight = level.weightOf(detail().rank[s]);
      ASSERT_GE(weight, before[s]);
      before[s] = weight;
    }
}

TEST(LevelOfDetail, AStrandFadesOverTheWholeOfTheFade) {
  LevelOfDetail level;
  for (level.fade = 0.05f; level.fade <= 1; level.fade *= 2)
    for (const float rank : {0.1f, 0.5f}) {
      level.strands = rank;
      EXPECT_NEAR(level.weightOf(rank), 1, 1e-5f);
      level.strands = rank / (1 + level.fade);
      EXPECT_NEAR(level.weightOf(rank), 0, 1e-5f);
      level.strands = rank / (1 + 0.5f * level.fade);
      EXPECT_NEAR(level.weightOf(rank), 0.5f, 1e-4f);
    }
}

TEST(GroomDetail, AnyShareOfTheRanksIsSpreadEvenlyOverTheScalp) {
  const std::vector<float>& rank = detail().rank;
  EXPECT_EQ(std::set<float>(rank.begin(), rank.end()).size(), rank.size());
  // Left and right, front and back: about the share of the whole.
  std::vector<glm::vec3> roots;
  for (const glm::uvec3 parents : curls().parents) roots.push_back(curls().guide(parents.x)[0]);
  for (const float share : {0.02f, 0.1f, 0.3f, 0.77f}) {
    double in[4] = {}, all[4] = {};
    for (std::size_t s = 0; s < rank.size(); ++s) {
      const int part = (roots[s].x > 0 ? 1 : 0) + (roots[s].z > 0 ? 2 : 0);
      ++all[part];
      if (rank[s] < share) ++in[part];
    }
    // At random it would be the root of the number.
    for (int part = 0; part < 4; ++part)
      EXPECT_NEAR(in[part], static_cast<double>(share) * all[part], 6) << share;
  }
}

TEST(GroomDetail, FewerPointsAreFartherOffAndShorter) {
  EXPECT_EQ(detail().deviation(1), 0);
  EXPECT_EQ(detail().lengthKept(1), 1);
  for (float points = 0.95f; points > 0.04f; points *= 0.95f) {
    EXPECT_GE(detail().deviation(points), detail().deviation(points / 0.95f));
    EXPECT_LT(detail().lengthKept(points), 1);
    EXPECT_GT(detail().lengthKept(points), 0.3f);
    // The inverse, from half of a hair's width on.
    const float off = detail().deviation(points);
    if (off <= 1e-4f) continue;
    EXPECT_NEAR(detail().deviation(detail().pointsFor(off + 0.5f * detail().fibreWidth)) / off, 1,
                1e-3f);
  }
  // Curls of 9 mm that have no points left are as far off as they are wide.
  EXPECT_GT(detail().deviation(0.05f), 4e-3f);
}

TEST(GroomDetail, HasTheSameBitsForAnyNumberOfThreads) {
  const ThreadLimit one(1);
  const GroomDetail alone(curls());
  EXPECT_EQ(alone.rank, detail().rank);
  EXPECT_EQ(alone.length, detail().length);
  EXPECT_EQ(alone.deviation(0.37f), detail().deviation(0.37f));
}

TEST(LevelOfDetail, AHeadIsAsHighAsTheCameraSeesIt) {
  // A picture of 2 m from bottom to top, 1000 pixels.
  EXPECT_NEAR(headPixels(1, 2 * std::atan(1.0f), 1000), 500 * kHeadHeight, 1e-3f);
  EXPECT_NEAR(headPixels(2, 2 * std::atan(1.0f), 1000), 250 * kHeadHeight, 1e-3f);
}

TEST(LevelOfDetail, RefusesWhatIsNoSizeInWords) {
  const auto refused = [](auto&& call, const std::string& word) {
    try {
      call();
      ADD_FAILURE() << "not refused: " << word;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  for (const float bad : {0.0f, -5.0f, NAN, INFINITY})
    refused([&] { levelFor(detail(), bad); }, "pixels high");
  for (const float bad : {0.0f, 1.5f, NAN})
    refused([&] { levelFor(detail(), 100, bad); }, "importance");
  for (const float bad : {0.0f, NAN}) {
    refused([&] { levelFor(detail(), 100, 1, {bad}); }, "strands per pixel");
    refused([&] { headPixels(bad, 0.5f, 100); }, "distance");
    refused([&] { headPixels(1, bad, 100); }, "fieldOfView");
    refused([&] { headPixels(1, 0.5f, bad); }, "picture");
    LevelOfDetail level;
    level.strands = bad;
    refused([&] { validate(level); }, "strands");
    level = {}, level.points = bad;
    refused([&] { validate(level); }, "points");
    level = {}, level.fade = bad;
    refused([&] { validate(level); }, "fade");
  }
  LevelOfDetail level;
  level.cellSize = NAN;
  refused([&] { validate(level); }, "cellSize");
}

}  // namespace
}  // namespace hair

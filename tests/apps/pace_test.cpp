// Real time to frames, and what the window remembers of the last ones.
#include <vector>

#include <gtest/gtest.h>

#include <apps/dance/history.h>
#include <apps/dance/pace.h>

namespace hair {
namespace {

TEST(Pace, FastPicturesKeepUpWithRealTime) {
  for (const double picture : {1.0 / 144, 1.0 / 60, 1.0 / 37}) {
    Pace pace(60);
    int frames = 0, pictures = 0;
    for (double t = 0; t < 10; t += picture, ++pictures) frames += pace.framesDue(picture);
    EXPECT_NEAR(frames, 60 * picture * pictures, 1) << picture;
    EXPECT_EQ(pace.droppedSeconds(), 0) << picture;
  }
}

TEST(Pace, SlowPicturesGiveSlowMotionAndCountWhatTheyDrop) {
  Pace pace(60, 2);
  int frames = 0;
  for (int i = 0; i < 40; ++i) {
    const int due = pace.framesDue(0.25);
    EXPECT_LE(due, 2);
    frames += due;
  }
  EXPECT_EQ(frames, 80);
  EXPECT_NEAR(frames / 60.0 + pace.droppedSeconds(), 10, 1e-6);
}

TEST(Pace, ALongStopIsNotCaughtUpWith) {
  Pace pace(60, 2);
  EXPECT_EQ(pace.framesDue(30), 2);
  EXPECT_EQ(pace.framesDue(0), 0);
  EXPECT_LE(pace.framesDue(1.0 / 60), 1);
}

TEST(Pace, SlowMotionNeedsFewerFramesAndDropsNone) {
  Pace pace(60);
  int frames = 0;
  for (int i = 0; i < 600; ++i) frames += pace.framesDue(1.0 / 60, 0.25);
  EXPECT_NEAR(frames, 150, 1);
  EXPECT_EQ(pace.droppedSeconds(), 0);
}

TEST(Recent, HoldsTheLastItemsOldestFirst) {
  Recent<float> recent(3);
  EXPECT_EQ(medianOf(recent, [](float x) { return x; }), 0);
  std::vector<float> all;
  for (const float x : {5.0f, 1.0f, 9.0f, 2.0f, 7.0f}) {
    recent.add(x);
    all.push_back(x);
    ASSERT_LE(recent.size(), 3u);
    for (std::size_t i = 0; i < recent.size(); ++i)
      EXPECT_EQ(recent[i], all[all.size() - recent.size() + i]);
    EXPECT_EQ(recent.last(), x);
  }
  EXPECT_EQ(medianOf(recent, [](float x) { return x; }), 7);  // of 9, 2, 7
}

}  // namespace
}  // namespace hair

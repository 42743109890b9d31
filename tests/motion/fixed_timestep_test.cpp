// Real time to frames.
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/motion/fixed_timestep.h>

namespace hair {
namespace {

TEST(FixedTimestep, FastPicturesKeepUpWithRealTime) {
  for (const double picture : {1.0 / 144, 1.0 / 60, 1.0 / 37}) {
    FixedTimestep pace(60);
    int frames = 0, pictures = 0;
    for (double t = 0; t < 10; t += picture, ++pictures) frames += pace.framesDue(picture);
    EXPECT_NEAR(frames, 60 * picture * pictures, 1) << picture;
    EXPECT_EQ(pace.droppedSeconds(), 0) << picture;
  }
}

TEST(FixedTimestep, SlowPicturesGiveSlowMotionAndCountWhatTheyDrop) {
  FixedTimestep pace(60, 2);
  int frames = 0;
  for (int i = 0; i < 40; ++i) {
    const int due = pace.framesDue(0.25);
    EXPECT_LE(due, 2);
    frames += due;
  }
  EXPECT_EQ(frames, 80);
  EXPECT_NEAR(frames / 60.0 + pace.droppedSeconds(), 10, 1e-6);
}

TEST(FixedTimestep, ALongStopIsNotCaughtUpWith) {
  FixedTimestep pace(60, 2);
  EXPECT_EQ(pace.framesDue(30), 2);
  EXPECT_EQ(pace.framesDue(0), 0);
  EXPECT_LE(pace.framesDue(1.0 / 60), 1);
}

TEST(FixedTimestep, TimeScalesFromATenthToThreeAndDropsNothing) {
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 1.7, 3.0}) {
    FixedTimestep pace(60);
    pace.setSpeed(speed);
    int frames = 0;
    for (int i = 0; i < 600; ++i) frames += pace.framesDue(1.0 / 60);
    EXPECT_NEAR(frames, 600 * speed, 1) << speed;
    EXPECT_EQ(pace.droppedSeconds(), 0) << speed;
  }
}

TEST(FixedTimestep, CatchesUpWithAHitchWithinItsBoundAndDropsTheRest) {
  // A picture that takes three frames' time: as many again may be caught up with in one.
  for (const double speed : {1.0, 3.0}) {
    FixedTimestep pace(60, 2);
    pace.setSpeed(speed);
    for (int i = 0; i < 10; ++i) pace.framesDue(1.0 / 60);
    EXPECT_EQ(pace.framesDue(3.0 / 60), static_cast<int>(2 * speed));
    EXPECT_NEAR(pace.droppedSeconds(), speed / 60, 1e-9);
    EXPECT_EQ(pace.framesDue(1.0 / 60), static_cast<int>(speed)) << "nothing more is owed";
  }
}

TEST(FixedTimestep, TimeThatPassesWhilePausedIsNeitherOwedNorDropped) {
  FixedTimestep paused(60), never(60);
  const double half = 0.5 / 60;  // of a frame: is owed over the pause
  EXPECT_EQ(paused.framesDue(half), never.framesDue(half));
  paused.setPaused(true);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(paused.framesDue(0.3), 0);
  paused.setPaused(false);
  EXPECT_EQ(paused.framesDue(half), 1);
  EXPECT_EQ(never.framesDue(half), 1);
  EXPECT_EQ(paused.droppedSeconds(), 0);
}

TEST(FixedTimestep, ClocksThatGoBackOrBreakStandStill) {
  FixedTimestep pace(60);
  EXPECT_EQ(pace.framesDue(-1), 0);
  EXPECT_EQ(pace.framesDue(std::nan("")), 0);
  EXPECT_EQ(pace.framesDue(INFINITY), 2);
  EXPECT_TRUE(std::isfinite(pace.droppedSeconds()));
  EXPECT_EQ(pace.framesDue(1.0 / 60), 1);
}

TEST(FixedTimestep, RefusesWhatIsNoPace) {
  EXPECT_THROW(FixedTimestep(0), Error);
  EXPECT_THROW(FixedTimestep(std::nan("")), Error);
  EXPECT_THROW(FixedTimestep(60, 0), Error);
  FixedTimestep pace(60);
  EXPECT_THROW(pace.setSpeed(-0.1), Error);
  EXPECT_THROW(pace.setSpeed(INFINITY), Error);
  EXPECT_EQ(pace.speed(), 1);
}

}  // namespace
}  // namespace hair

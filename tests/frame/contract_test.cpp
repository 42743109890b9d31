// What users of a motion may rely on: docs/guarantees.md.

#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/motion/fixed_timestep.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;
using test::stateOf;

TEST(Contract, ARestartGivesTheFirstFramesAgain) {
  Scene scene(small(Style::Smooth), Motion::dance(), {});
  const auto firstFrames = [&] {
    std::vector<std::string> states;
    scene.time = 0;
    restart(scene.bodyAt(0), scene.settings, 0.1f, scene.hair);
    states.push_back(stateOf(scene.hair));
    for (int f = 0; f < 20; ++f) {
      scene.step();
      if (f == 0 || f == 19) states.push_back(stateOf(scene.hair));
    }
    return std::pair(states, scene.hair.colours);
  };
  const auto first = firstFrames();
  for (int f = 0; f < 15; ++f) scene.step();
  EXPECT_NE(stateOf(scene.hair), first.first.back());
  EXPECT_EQ(firstFrames(), first);
}

TEST(Contract, ARestartWhereItStandsKeepsTheBody) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  restart(scene.hair.body(), scene.settings, 0.1f, scene.hair);
  ASSERT_EQ(scene.hair.capsules.size(), scene.pose.capsules.size());
  for (std::size_t c = 0; c < scene.hair.capsules.size(); ++c)
    EXPECT_EQ(scene.hair.capsules[c].radius, scene.pose.capsules[c].radius);
}

TEST(Contract, HairThatStartsInTheMiddleOfAClipIsAtRestAndIsNotShaken) {
  const auto fastest = [](Scene& scene) {
    float speed = 0;
    for (int f = 0; f < 30; ++f) {
      scene.step();
      speed = std::max(speed, scene.stats().speedMax);
    }
    return speed;
  };
  double most = 0;
  const FrameSettings settings = Scene::simulationOnly();
  Scene danced(small(Style::Smooth), Motion::dance(), settings);
  for (const double t : {2.0, 4.5, 6.0, 9.0}) {
    while (danced.time < t - 1e-3) danced.step();
    Scene started(small(Style::Smooth), Motion::dance(), settings);
    started.hair = Hair(started.groom, started.settings, started.bodyAt(t), &started.collider);
    EXPECT_EQ(started.stats().speedMax, 0);
    started.time = t;
    started.simulation.restart(started.bodyAt(t), 0.5f);
    EXPECT_EQ(started.stats().speedMax, 0);
    EXPECT_LT(started.stats().penetrationMax, 1e-3f) << t;
    const float with = fastest(started), without = fastest(danced);
    most = std::max(most, static_cast<double>(with / without));
  }
  RecordProperty("fastest_against_danced", std::to_string(most));
  EXPECT_LT(most, 1.5);
}

TEST(Contract, LightingAPausedHairChangesNothingOfItsMotion) {
  Scene paused(small(Style::Curly), Motion::dance(), {}),
      never(small(Style::Curly), Motion::dance());
  FrameSettings other = paused.settings;
  for (int f = 0; f < 20; ++f) {
    paused.step(), never.step();
    const std::string before = stateOf(paused.hair);
    other.lights = {Light::point({0.1f * static_cast<float>(f), 2, 1}), Light{}};
    other.bodyShadow = f % 2 == 0;
    other.shadow = f % 3 != 0;
    other.eye.x += 0.1f;
    light(other, paused.hair, paused.profile);
    ASSERT_EQ(stateOf(paused.hair), before);
  }
  EXPECT_TRUE(stateOf(paused.hair) == stateOf(never.hair));
  light(paused.settings, never.hair, never.profile);
  paused.step();
  never.settings = paused.settings;
  never.step();
  EXPECT_TRUE(stateOf(paused.hair) == stateOf(never.hair));
  EXPECT_EQ(paused.hair.colours, never.hair.colours);
}

TEST(Contract, TwoHairsInTwoThreadsDoNotDisturbEachOther) {
  const auto run = [](Style style, std::string& state) {
    Scene scene(small(style), Motion::dance(), {});
    for (int f = 0; f < 30; ++f) scene.step();
    state = stateOf(scene.hair);
  };
  std::string alone[2], together[2];
  run(Style::Smooth, alone[0]);
  run(Style::Curly, alone[1]);
  std::thread other(run, Style::Curly, std::ref(together[1]));
  run(Style::Smooth, together[0]);
  other.join();
  EXPECT_EQ(together[0], alone[0]);
  EXPECT_EQ(together[1], alone[1]);
}

TEST(Contract, AFrameOfNoLengthOrLongerThanASecondIsRefusedAndChangesNothing) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  const std::string before = stateOf(scene.hair);
  for (const float seconds : {1.5f, 0.0f, -0.1f, std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(frame(scene.bodyAt(2), scene.settings, seconds, scene.hair, scene.profile), Error);
    EXPECT_TRUE(stateOf(scene.hair) == before);
  }
  scene.step(1);
  EXPECT_LT(scene.stats().stretchMax, 1e-2f);
  EXPECT_LT(scene.stats().penetrationMax, 1e-3f);
}

TEST(Contract, SlowMotionIsTheSameMotion) {
  const auto after24Frames = [](double speed, double picture) {
    Scene scene(small(Style::Smooth), Motion::dance());
    FixedTimestep pace(60);
    pace.setSpeed(speed);
    for (int frames = 0; frames < 24;)
      for (int due = pace.framesDue(picture); due > 0 && frames < 24; --due, ++frames) scene.step();
    return stateOf(scene.hair);
  };
  const std::string asItIs = after24Frames(1, 1.0 / 60);
  EXPECT_EQ(after24Frames(0.1, 1.0 / 60), asItIs);
  EXPECT_EQ(after24Frames(3, 1.0 / 60), asItIs);
  EXPECT_EQ(after24Frames(0.7, 1.0 / 37), asItIs);
}

}  // namespace
}  // namespace hair

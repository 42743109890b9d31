// A frame works in memory that is there: the global allocation functions of this program count.

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <tests/allocations.h>

#include "scene.h"

namespace hair {
namespace {

TEST(Frame, AllocatesNothing) {
  // One thread: the scheduler of a threading library keeps books of its own.
  const ThreadLimit limit(1);
  FrameSettings settings;
  settings.lights.push_back(Light::point({1, 2, 1}));
  settings.bodyShadow = true;
  settings.wind.velocity = {1, 0, 0.5f};
  test::Scene scene(test::small(Style::Smooth), Motion::dance(), settings);
  const auto play = [&] {
    scene.time = 0;
    for (const float seconds : {1.0f / 60, 1.0f / 24, 1.0f / 144})
      for (int f = 0; f < 10; ++f) scene.step(seconds);
  };
  // Memory is kept for the most that there was: of substeps in a frame, and of cells with hair.
  play();
  restart(scene.bodyAt(0), settings, 0, scene.hair);
  const std::size_t before = test::allocationCount();
  play();
  EXPECT_EQ(test::allocationCount() - before, 0u);
}

}  // namespace
}  // namespace hair

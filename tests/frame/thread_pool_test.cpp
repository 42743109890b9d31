// The same hair on anybody's threads.

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/wisps/bind.h>
#include <tests/thread_pools.h>

#include "scene.h"

namespace hair {
namespace {

using test::Order;
using test::OwnPool;

struct Outcome {
  std::string state;
  std::vector<std::uint32_t> colours;
  std::vector<float> transmittance;
  std::vector<glm::vec3> bound;
  bool operator==(const Outcome&) const = default;
};

// Everything that a program asks of the library: a style is grown, danced, shadowed and bound.
Outcome dance() {
  FrameSettings settings;
  settings.lights.push_back(Light::point({1, 2, 1}));
  settings.bodyShadow = true;
  settings.wind.velocity = {2, 0, 1};
  // As many strands as it takes for several threads to write into one map.
  test::Scene scene(styleSettings(Style::Curly), Motion::dance(), settings);
  for (int f = 0; f < 4; ++f) scene.step();
  return {test::stateOf(scene.hair), scene.hair.colours, scene.hair.transmittance,
          bindGroom(scene.hair.strands(), {.guides = 50}).offsets};
}

TEST(ThreadPool, HairHasTheSameBitsOnAnyThreads) {
  const Outcome expected = dance();
  {
    const ThreadLimit one(1);
    EXPECT_TRUE(dance() == expected);
  }
  for (const int threads : {1, 3, 7}) {
    OwnPool pool(threads);
    const ThreadPoolScope scope(pool);
    EXPECT_TRUE(dance() == expected) << threads;
    EXPECT_EQ(pool.runs > 0, threads > 1);
  }
}

TEST(ThreadPool, HairHasTheSameBitsInAnyOrderOfTasks) {
  const Outcome expected = dance();
  for (const Order order : {Order::Backward, Order::Random})
    for (const int threads : {2, 5}) {
      OwnPool pool(threads, order);
      const ThreadPoolScope scope(pool);
      EXPECT_TRUE(dance() == expected) << threads;
    }
}

}  // namespace
}  // namespace hair

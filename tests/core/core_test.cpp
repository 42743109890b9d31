#include <atomic>
#include <sstream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#ifdef HAIR_THREADS_TBB
#include <tbb/task_arena.h>
#endif

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/profile.h>
#include <libhair/core/random.h>
#include <libhair/core/state_hash.h>
#include <libhair/core/strands.h>
#include <libhair/core/transform.h>

namespace hair {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnceForAnyThreadCount) {
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(threadCount(), threads);
    for (std::size_t count : {0u, 1u, 5u, 1000u}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, 3, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& v : visits) ASSERT_EQ(v, 1);
    }
  }
}

TEST(Parallel, ExceptionsReachTheCaller) {
  const ThreadLimit limit(2);
  EXPECT_THROW(parallelFor(100, 1, [](std::size_t, std::size_t) { throw Error("from a range"); }),
               Error);
}

TEST(Strands, TheDoorNamesStrandAndPoint) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}});
  strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, NAN, 0}});
  try {
    validate(strands, "input");
    FAIL() << "NaN passed the door";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("input: strand 1 point 1"), std::string::npos) << e.what();
  }
  EXPECT_THROW(validate({strands.points, {}}, "no offsets"), Error);
}

TEST(Parallel, ALimitIsOfTheThreadThatSetIt) {
  const ThreadLimit limit(3);
  EXPECT_EQ(threadCount(), 3);
  int elsewhere = 0;
  std::thread([&] {
    const ThreadLimit other(5);
    elsewhere = threadCount();
  }).join();
  EXPECT_EQ(elsewhere, 5);
  EXPECT_EQ(threadCount(), 3);
}

#ifdef HAIR_THREADS_TBB
TEST(Parallel, WorksInTheCallersOwnArena) {
  tbb::task_arena arena(1);
  arena.execute([] {
    EXPECT_EQ(threadCount(), 1);
    const auto caller = std::this_thread::get_id();
    parallelFor(1000, 1,
                [&](std::size_t, std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
  });
}
#endif

TEST(Transform, TransportTurnsFromIntoToAndKeepsAngles) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    const auto direction = [&](std::uint32_t use) {
      return glm::normalize(glm::vec3(uniform(i, use) - 0.5f, uniform(i, use + 1) - 0.5f,
                                      uniform(i, use + 2) - 0.5f));
    };
    const glm::vec3 a = direction(0), b = direction(3), v = direction(6);
    EXPECT_LT(glm::distance(transport(a, a, b), b), 1e-5f);
    EXPECT_NEAR(glm::dot(transport(v, a, b), b), glm::dot(v, a), 1e-5f);
    // Shortest: what is normal to both directions stays where it is.
    const glm::vec3 axis = glm::normalize(glm::cross(a, b));
    EXPECT_LT(glm::distance(transport(axis, a, b), axis), 1e-4f);
  }
  EXPECT_LT(glm::distance(transport({1, 0, 0}, {1, 0, 0}, {-1, 0, 0}), glm::vec3(-1, 0, 0)), 1e-6f);
}

TEST(Transform, BlendMeetsItsEnds) {
  const RigidTransform a{glm::angleAxis(0.3f, glm::vec3(0, 1, 0)), {1, 2, 3}};
  const RigidTransform b{glm::angleAxis(2.0f, glm::vec3(0, 0, 1)), {-1, 0, 1}};
  const glm::vec3 p(0.1f, 0.2f, 0.3f);
  EXPECT_LT(glm::distance(blend(a, b, 0).point(p), a.point(p)), 1e-6f);
  EXPECT_LT(glm::distance(blend(a, b, 1).point(p), b.point(p)), 1e-6f);
  EXPECT_LT(glm::distance((inverse(a) * a).point(p), p), 1e-6f);
}

TEST(StateHash, SeesOneBitAndOrder) {
  const auto hash = [](std::vector<float> v) {
    StateHash h;
    h.add(std::span<const float>(v));
    return h.value();
  };
  EXPECT_EQ(hash({1, 2, 3}), hash({1, 2, 3}));
  EXPECT_NE(hash({1, 2, 3}), hash({1, 3, 2}));
  EXPECT_NE(hash({0.0f}), hash({-0.0f}));
  EXPECT_NE(hash({0.0f}), hash({0.0f, 0.0f}));
}

TEST(Profile, QuantilesAndRowsAreOfTheFramesAdded) {
  ProfileLog log;
  for (int i = 1; i <= 5; ++i) {
    FrameProfile frame{};
    frame[static_cast<std::size_t>(Stage::Guides)] = {i * 1'000'000, 10};
    log.add(frame);
  }
  EXPECT_DOUBLE_EQ(log.milliseconds(Stage::Guides, 0.5), 3.0);
  std::ostringstream csv;
  log.writeCsv(csv);
  EXPECT_EQ(csv.str(), "stage,items,ms_median,ms_p95\nguides,10,3,5\ntotal,10,3,5\n");
}

TEST(Profile, ALongLogKeepsSomeFramesFromAllOfItsLength) {
  ProfileLog log;
  constexpr int kFrames = 100'000;
  for (int i = 0; i < kFrames; ++i) {
    FrameProfile frame{};
    frame[static_cast<std::size_t>(Stage::Guides)] = {i, 10};
    log.add(frame);
  }
  EXPECT_EQ(log.frameCount(), static_cast<std::size_t>(kFrames));
  EXPECT_LE(log.keptCount(), ProfileLog::kMostFrames);
  // Between two that were kept there are at most 2 · 100000 / kMostFrames others.
  const double gap = 2e-6 * kFrames / ProfileLog::kMostFrames;
  for (const double q : {0.0, 0.25, 0.5, 0.95, 1.0})
    EXPECT_NEAR(log.milliseconds(Stage::Guides, q), 1e-6 * kFrames * q, gap) << q;
}

}  // namespace
}  // namespace hair

// Loops on threads that are the caller's own.

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <tests/allocations.h>
#include <tests/thread_pools.h>

namespace hair {
namespace {

using test::Order;
using test::OwnPool;

TEST(ThreadPool, VisitsEveryIndexOnceInAnyOrderOfTasks) {
  for (const Order order : {Order::Forward, Order::Backward, Order::Random})
    for (const int threads : {1, 2, 7}) {
      OwnPool pool(threads, order);
      const ThreadPoolScope scope(pool);
      EXPECT_EQ(threadCount(), threads);
      for (std::size_t count : {0u, 1u, 5u, 1000u}) {
        std::vector<std::atomic<int>> visits(count);
        parallelFor(count, 3, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        for (const auto& v : visits) ASSERT_EQ(v, 1);
      }
      // One thread is the calling one, which needs no pool.
      EXPECT_EQ(pool.runs > 0, threads > 1);
    }
}

TEST(ThreadPool, DoesAllOfItsWorkInItsOwnThreads) {
  // Every task in a thread that this pool made: none in one of the library's.
  class Marked final : public ThreadPool {
   public:
    int threadCount() const override { return 4; }
    void run(std::size_t taskCount, const Tasks& tasks) override {
      std::thread([&] {
        worker = std::this_thread::get_id();
        for (std::size_t i = 0; i < taskCount; ++i) tasks(i);
      }).join();
    }
    std::thread::id worker;
  } pool;
  const ThreadPoolScope scope(pool);
  parallelFor(1000, 1, [&](std::size_t, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), pool.worker);
    EXPECT_EQ(threadCount(), 1);
    // A loop inside a loop stays in its thread.
    parallelFor(100, 1, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(std::this_thread::get_id(), pool.worker);
      EXPECT_EQ(end - begin, 100u);
    });
  });
}

TEST(ThreadPool, PassesOnTheExceptionOfTheFirstRangeThatThrewOne) {
  for (const Order order : {Order::Forward, Order::Backward, Order::Random}) {
    OwnPool pool(3, order);
    const ThreadPoolScope scope(pool);
    std::atomic<int> ranges = 0;
    try {
      parallelFor(1200, 1, [&](std::size_t begin, std::size_t) {
        ++ranges;
        if (begin >= 500) throw Error(text("from ", begin));
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "from 500");
    }
    EXPECT_EQ(ranges, 12);
  }
}

TEST(ThreadPool, TheInnermostOfPoolAndLimitIsUsedInTheThreadThatMadeIt) {
  OwnPool three(3), five(5);
  const int outside = threadCount();
  {
    const ThreadPoolScope a(three);
    {
      const ThreadPoolScope b(five);
      EXPECT_EQ(threadCount(), 5);
      {
        const ThreadLimit c(2);
        EXPECT_EQ(threadCount(), 2);
        const ThreadPoolScope d(three);
        EXPECT_EQ(threadCount(), 3);
      }
      EXPECT_EQ(threadCount(), 5);
      int elsewhere = 0;
      std::thread([&] { elsewhere = threadCount(); }).join();
      EXPECT_EQ(elsewhere, outside);
    }
    EXPECT_EQ(threadCount(), 3);
  }
  EXPECT_EQ(threadCount(), outside);
}

TEST(ThreadPool, ThatForgetsATaskOrHasNoThreadsIsReported) {
  class Broken final : public ThreadPool {
   public:
    int threads = 4;
    std::size_t forgets = 1, adds = 0;
    int threadCount() const override { return threads; }
    void run(std::size_t taskCount, const Tasks& tasks) override {
      for (std::size_t i = forgets; i < taskCount + adds; ++i) tasks(i);
    }
  } pool;
  const auto outcome = [&] {
    try {
      const ThreadPoolScope scope(pool);
      parallelFor(100, 1, [](std::size_t, std::size_t) {});
      return std::string("done");
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(outcome().find("did 15 of 16 tasks"), std::string::npos) << outcome();
  pool.forgets = 0;
  EXPECT_EQ(outcome(), "done");
  pool.adds = 1;
  EXPECT_NE(outcome().find("task 16 of 16"), std::string::npos) << outcome();
  for (pool.threads = -1; pool.threads < 1; ++pool.threads)
    EXPECT_NE(outcome().find("not in 1 to 1024"), std::string::npos) << outcome();
}

TEST(ThreadPool, TheLibraryAllocatesNothingForIt) {
  class Caller final : public ThreadPool {
   public:
    int threadCount() const override { return 8; }
    void run(std::size_t taskCount, const Tasks& tasks) override {
      for (std::size_t i = 0; i < taskCount; ++i) tasks(i);
    }
  } pool;
  std::size_t sum = 0;
  const std::size_t before = test::allocationCount();
  {
    const ThreadPoolScope scope(pool);
    parallelFor(1000, 1, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
  }
  EXPECT_EQ(test::allocationCount(), before);
  EXPECT_EQ(sum, 1000u);
}

#ifdef HAIR_THREADS_TBB
TEST(Parallel, AThreadThatHasALimitTakesNoThreadsFromAnother) {
  // The first range waits for the second: there are two threads at work, or it waits in vain.
  const auto meet = [] {
    const ThreadLimit two(2);
    std::atomic<int> there = 0;
    std::atomic<bool> met = false;
    parallelFor(2, 1, [&](std::size_t, std::size_t) {
      const bool first = ++there == 1;
      for (int i = 0; i < 2000 && there < 2; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (first && there == 2) met = true;
    });
    return met.load();
  };
  const ThreadLimit one(1);
  bool met = false;
  std::thread([&] { met = meet(); }).join();
  EXPECT_TRUE(met);
}
#endif

}  // namespace
}  // namespace hair

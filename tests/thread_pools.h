#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

#include <libhair/core/parallel.h>
#include <libhair/core/random.h>

namespace hair::test {

/// In which order a pool takes up its tasks.
enum class Order { Forward, Backward, Random };

/// Somebody else's threads: as many as they like, tasks in any order.
class OwnPool final : public ThreadPool {
 public:
  explicit OwnPool(int threads, Order order = Order::Forward) : threads_(threads), order_(order) {}

  int threadCount() const override { return threads_; }
  void run(std::size_t taskCount, const Tasks& tasks) override {
    const std::vector<std::size_t> order = ordered(taskCount);
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (int t = 0; t < threads_; ++t)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < taskCount; i = next++) tasks(order[i]);
      });
    runs += 1;
  }

  std::atomic<int> runs = 0;

 private:
  std::vector<std::size_t> ordered(std::size_t count) const {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (order_ == Order::Backward) std::reverse(order.begin(), order.end());
    if (order_ == Order::Random)
      for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[hashWord(static_cast<std::uint32_t>(i + 97 * count)) % i]);
    return order;
  }

  int threads_;
  Order order_;
};

}  // namespace hair::test

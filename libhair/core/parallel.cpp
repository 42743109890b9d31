#include <libhair/core/parallel.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <libhair/core/error.h>

#ifdef HAIR_THREADS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace hair {

namespace {

int machineThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int checkedThreads(int threads) {
  require(threads >= 0 && threads <= 1024, "--threads: ", threads, " is not in 0 to 1024");
  return threads > 0 ? threads : machineThreads();
}

}  // namespace

#ifdef HAIR_THREADS_TBB

struct ThreadLimit::State {
  // An arena alone gets no more workers than the machine has processors; the control lifts that.
  tbb::global_control control;
  tbb::task_arena arena;
  tbb::task_arena* outer;
};

namespace {
// Of the thread that made it: what another thread computes at the same time is not limited.
thread_local tbb::task_arena* innermost = nullptr;
}  // namespace

ThreadLimit::ThreadLimit(int threads) : state_(nullptr) {
  const int n = checkedThreads(threads);
  state_ = new State{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(n)),
                     tbb::task_arena(n), innermost};
  innermost = &state_->arena;
}

ThreadLimit::~ThreadLimit() {
  innermost = state_->outer;
  delete state_;
}

int threadCount() {
  return innermost ? innermost->max_concurrency() : tbb::this_task_arena::max_concurrency();
}

void detail::parallelFor(std::size_t count, std::size_t grain, RangeBody body, void* context) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const auto threads = static_cast<std::size_t>(threadCount());
  if (threads == 1 || count <= grain) return body(context, 0, count);
  const auto run = [&] {
    // A few chunks a thread: enough to even out, few enough that a chunk is worth its task.
    const std::size_t chunks = std::min(count / grain, threads * 4);
    tbb::parallel_for(
        std::size_t{0}, chunks,
        [&](std::size_t c) { body(context, count * c / chunks, count * (c + 1) / chunks); },
        tbb::simple_partitioner{});
  };
  if (innermost)
    innermost->execute(run);
  else
    run();
}

#else

struct ThreadLimit::State {
  int outerThreads;
};

namespace {
thread_local int limitedThreads = 0;  // 0 outside any ThreadLimit
}

int threadCount() {
  return limitedThreads > 0 ? limitedThreads : machineThreads();
}

ThreadLimit::ThreadLimit(int threads) : state_(nullptr) {
  const int n = checkedThreads(threads);
  state_ = new State{limitedThreads};
  limitedThreads = n;
}

ThreadLimit::~ThreadLimit() {
  limitedThreads = state_->outerThreads;
  delete state_;
}

// Plain threads, made and joined per call: slow, but every happens-before edge is one that
// ThreadSanitizer knows.
void detail::parallelFor(std::size_t count, std::size_t grain, RangeBody body, void* context) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = std::min(count / grain, static_cast<std::size_t>(threadCount()));
  if (chunks <= 1) return body(context, 0, count);
  std::mutex mutex;
  std::exception_ptr failure;
  {
    std::vector<std::jthread> threads;
    for (std::size_t c = 0; c < chunks; ++c)
      threads.emplace_back([&, c] {
        try {
          body(context, count * c / chunks, count * (c + 1) / chunks);
        } catch (...) {
          const std::lock_guard lock(mutex);
          failure = std::current_exception();
        }
      });
  }
  if (failure) std::rethrow_exception(failure);
}

#endif

}  // namespace hair

#include <libhair/core/parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <libhair/core/error.h>

#ifdef HAIR_THREADS_TBB
#include <optional>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#else
#include <vector>
#endif

namespace hair {

namespace {

// Of the thread that made the scope: what another thread computes at the same time is its own.
struct PoolInUse {
  ThreadPool* pool = nullptr;  // null: the library's own threads
  int threads = 0;             // of the pool
};
thread_local PoolInUse inUse;

int machineThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int checkedThreads(int threads) {
  require(threads >= 0 && threads <= 1024, "threads: ", threads, " is not in 0 to 1024");
  return threads > 0 ? threads : machineThreads();
}

// A loop that is cut into chunks.
struct Loop {
  std::size_t count, grain;
  detail::RangeBody body;
  void* context;
  std::size_t chunks = 1;

  void cut(std::size_t most) { chunks = std::min(count / grain, most); }
  void run(std::size_t chunk) const {
    body(context, count * chunk / chunks, count * (chunk + 1) / chunks);
  }
};

// Of the exceptions that chunks throw, that of the first of them.
class Failure {
 public:
  void keep(std::size_t chunk) {
    const std::lock_guard lock(mutex_);
    if (exception_ && chunk_ < chunk) return;
    exception_ = std::current_exception();
    chunk_ = chunk;
  }
  void passOn() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::size_t chunk_ = 0;
};

}  // namespace

#ifdef HAIR_THREADS_TBB

struct ThreadLimit::State {
  // An arena alone gets no more workers than the machine has processors; the control lifts that.
  // Without need there is none: it is of the whole process, and the least of all that live counts.
  std::optional<tbb::global_control> control;
  tbb::task_arena arena;
  tbb::task_arena* outer;
  PoolInUse outerPool;
};

namespace {

thread_local tbb::task_arena* innermost = nullptr;

int ownThreads() {
  return innermost ? innermost->max_concurrency() : tbb::this_task_arena::max_concurrency();
}

void runOnOwnThreads(std::size_t threads, Loop loop) {
  const auto run = [&] {
    // A few chunks a thread: enough to even out, few enough that a chunk is worth its task.
    loop.cut(4 * threads);
    tbb::parallel_for(
        std::size_t{0}, loop.chunks, [&](std::size_t c) { loop.run(c); },
        tbb::simple_partitioner{});
  };
  if (innermost)
    innermost->execute(run);
  else
    run();
}

}  // namespace

ThreadLimit::ThreadLimit(int threads) : state_(nullptr) {
  const int n = checkedThreads(threads);
  state_ = new State{{}, tbb::task_arena(n), innermost, std::exchange(inUse, {})};
  if (n > tbb::info::default_concurrency())
    state_->control.emplace(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(n));
  innermost = &state_->arena;
}

ThreadLimit::~ThreadLimit() {
  innermost = state_->outer;
  inUse = state_->outerPool;
  delete state_;
}

#else

struct ThreadLimit::State {
  int outerThreads;
  PoolInUse outerPool;
};

namespace {

thread_local int limitedThreads = 0;  // 0 outside any ThreadLimit

int ownThreads() {
  return limitedThreads > 0 ? limitedThreads : machineThreads();
}

// Plain threads, made and joined per call: slow, but every happens-before edge is one that
// ThreadSanitizer knows.
void runOnOwnThreads(std::size_t threads, Loop loop) {
  loop.cut(threads);
  Failure failure;
  {
    std::vector<std::jthread> running;
    for (std::size_t c = 0; c < loop.chunks; ++c)
      running.emplace_back([&, c] {
        try {
          loop.run(c);
        } catch (...) {
          failure.keep(c);
        }
      });
  }
  failure.passOn();
}

}  // namespace

ThreadLimit::ThreadLimit(int threads) : state_(nullptr) {
  const int n = checkedThreads(threads);
  state_ = new State{limitedThreads, std::exchange(inUse, {})};
  limitedThreads = n;
}

ThreadLimit::~ThreadLimit() {
  limitedThreads = state_->outerThreads;
  inUse = state_->outerPool;
  delete state_;
}

#endif

namespace {

// Whose turn it is inside a task of a pool: there might be no thread left for a loop in a loop.
class Alone final : public ThreadPool {
 public:
  int threadCount() const override { return 1; }
  void run(std::size_t taskCount, const Tasks& tasks) override {
    for (std::size_t i = 0; i < taskCount; ++i) tasks(i);
  }
};

void runOnPool(const PoolInUse& own, Loop loop) {
  loop.cut(4 * static_cast<std::size_t>(own.threads));
  struct Work {
    const Loop& loop;
    Failure failure{};
    std::atomic<std::size_t> done = 0;
  } work{loop};
  const ThreadPool::Tasks tasks(
      [](void* context, std::size_t chunk) {
        Work& w = *static_cast<Work*>(context);
        try {
          require(chunk < w.loop.chunks, "thread pool: its run() did task ", chunk, " of ",
                  w.loop.chunks);
          Alone alone;
          const ThreadPoolScope here(alone);
          w.loop.run(chunk);
        } catch (...) {
          w.failure.keep(chunk);
        }
        ++w.done;
      },
      &work);
  own.pool->run(loop.chunks, tasks);
  work.failure.passOn();
  require(work.done == loop.chunks, "thread pool: its run() did ", work.done.load(), " of ",
          loop.chunks, " tasks; it must do each once, and return when the last is done");
}

}  // namespace

ThreadPoolScope::ThreadPoolScope(ThreadPool& pool)
    : outer_(inUse.pool), outerThreads_(inUse.threads) {
  const int threads = pool.threadCount();
  require(threads >= 1 && threads <= 1024, "thread pool: its threadCount() ", threads,
          " is not in 1 to 1024");
  inUse = {&pool, threads};
}

ThreadPoolScope::~ThreadPoolScope() {
  inUse = {outer_, outerThreads_};
}

int threadCount() {
  return inUse.pool ? inUse.threads : ownThreads();
}

void detail::parallelFor(std::size_t count, std::size_t grain, RangeBody body, void* context) {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const auto threads = static_cast<std::size_t>(threadCount());
  if (threads == 1 || count <= grain) return body(context, 0, count);
  const Loop loop{count, grain, body, context};
  if (inUse.pool)
    runOnPool(inUse, loop);
  else
    runOnOwnThreads(threads, loop);
}

}  // namespace hair

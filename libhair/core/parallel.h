#pragma once

#include <cstddef>
#include <type_traits>

#include <libhair/core/api.h>

namespace HAIR_API hair {

namespace detail {
using RangeBody = void (*)(void* context, std::size_t begin, std::size_t end);
void parallelFor(std::size_t count, std::size_t grain, RangeBody body, void* context);
}  // namespace detail

/// Calls body(begin, end) on disjoint ranges that cover [0, count), on the threads there are: those
/// of oneTBB, or of the caller's own pool (ThreadPoolScope).
/// No range but the last is shorter than `grain`; with one thread, or count <= grain, it is one
/// call on the calling thread. A pass writes only to its own range: results never depend on how
/// the work was cut. Exceptions thrown by body are passed on.
template <class Body>
void parallelFor(std::size_t count, std::size_t grain, Body&& body) {
  using Plain = std::remove_reference_t<Body>;
  detail::parallelFor(
      count, grain,
      [](void* context, std::size_t begin, std::size_t end) {
        (*static_cast<Plain*>(context))(begin, end);
      },
      const_cast<void*>(static_cast<const void*>(&body)));
}

/// Threads that parallelFor may use now, the calling one included: as many as the machine has, as a
/// ThreadPoolScope or ThreadLimit says, or as the oneTBB arena that the caller is in
/// (tbb::task_arena::execute around any call of the library makes that call run in the caller's own
/// arena).
int threadCount();

/// While it lives, parallelFor, called from the thread that made it, uses exactly `threads` threads
/// (0: as many as the machine has), even where the machine has fewer processors. It goes before a
/// ThreadPoolScope around it.
class ThreadLimit {
 public:
  /// Throws Error for `threads` not in [0, 1024].
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  State* state_;
};

/// Threads that are the caller's own: the job system of an engine, the pool of a renderer. The
/// library asks for nothing but this, and starts no threads of its own while it uses it.
class ThreadPool {
 public:
  /// A loop cut into tasks. Refers to what it does, and is there only as long as run() is.
  class Tasks {
   public:
    /// Does task i. Once for each i below the count, in any order, from any thread, also from
    /// several at once. Throws nothing: what a task throws is kept, and parallelFor passes it on.
    void operator()(std::size_t i) const noexcept { call_(context_, i); }

    /// Made by the library. `call` must not throw.
    Tasks(void (*call)(void*, std::size_t), void* context) : call_(call), context_(context) {}

   private:
    void (*call_)(void*, std::size_t);
    void* context_;
  };

  virtual ~ThreadPool() = default;

  /// How many tasks run at once, 1 to 1024; the calling thread counts if it helps. Loops are cut
  /// into a few tasks for each. Results have the same bits whatever it says.
  virtual int threadCount() const = 0;

  /// Does all tasks, 0 to taskCount - 1, and returns when the last is done. A task waits for no
  /// other, so one thread is enough; loops inside a task are run by that task's thread alone.
  virtual void run(std::size_t taskCount, const Tasks& tasks) = 0;
};

/// While it lives, parallelFor, called from the thread that made it, runs on that pool: all that
/// the library does in that thread. Scopes of other threads may use the same pool, if its run() may
/// be called from several threads. It goes before a ThreadLimit around it. Make and destroy it in
/// one thread, the last one made first.
/// Throws Error where the pool's threadCount() is not in 1 to 1024; it is asked once.
class ThreadPoolScope {
 public:
  /// The pool must outlive the scope.
  explicit ThreadPoolScope(ThreadPool& pool);
  ~ThreadPoolScope();
  ThreadPoolScope(const ThreadPoolScope&) = delete;
  ThreadPoolScope& operator=(const ThreadPoolScope&) = delete;

 private:
  ThreadPool* outer_;
  int outerThreads_;
};

}  // namespace hair

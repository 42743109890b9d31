#pragma once

#include <cstddef>
#include <type_traits>

#include <libhair/core/api.h>

namespace HAIR_API hair {

namespace detail {
using RangeBody = void (*)(void* context, std::size_t begin, std::size_t end);
void parallelFor(std::size_t count, std::size_t grain, RangeBody body, void* context);
}  // namespace detail

/// Calls body(begin, end) on disjoint ranges that cover [0, count), on the threads there are.
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

/// Threads that parallelFor may use now, the calling one included: as many as the machine has, or
/// as the oneTBB arena that the caller is in (tbb::task_arena::execute around any call of the
/// library makes that call run in the caller's own arena).
int threadCount();

/// While it lives, parallelFor, called from the thread that made it, uses exactly `threads` threads
/// (0: as many as the machine has), even where the machine has fewer processors.
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

}  // namespace hair

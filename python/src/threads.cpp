// How many threads calls may use.
#include <memory>
#include <thread>

#include <libhair/core/parallel.h>

#include "arrays.h"
#include "topics.h"

namespace hair::python {

namespace {

/// ThreadLimit as a context manager.
struct Limit {
  int threads;
  std::unique_ptr<ThreadLimit> limit{};
  std::thread::id owner{};

  void enter() {
    if (limit) throw std::runtime_error("thread_limit: entered twice; make another one");
    limit = std::make_unique<ThreadLimit>(threads);
    owner = std::this_thread::get_id();
  }
  void exit() {
    if (!limit || owner != std::this_thread::get_id())
      throw std::runtime_error("thread_limit: left by another thread than entered it");
    limit.reset();
  }
};

}  // namespace

void bindThreads(py::module_& m) {
  m.def("thread_count", &threadCount, "Threads that a call made here may use.");
  py::class_<Limit>(m, "thread_limit",
                    R"(with thread_limit(n): calls of this Python thread use n threads.

0: as many as the machine has. Results have the same bits for any number of threads.)")
      .def(py::init([](int threads) {
             // Out of range is said now, not at `with`.
             const ThreadLimit checked(threads);
             return std::make_unique<Limit>(Limit{threads});
           }),
           py::arg("threads"), "threads: 0 to 1024.")
      .def(
          "__enter__",
          [](const py::object& self) {
            self.cast<Limit&>().enter();
            return self;
          },
          "Begins.")
      .def(
          "__exit__", [](Limit& limit, const py::args&) { limit.exit(); }, "Ends.")
      .def("__repr__", [](const Limit& limit) {
        return "thread_limit(" + std::to_string(limit.threads) + ")";
      });
}

}  // namespace hair::python

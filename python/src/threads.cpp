// How many threads calls may use.
#include "threads.h"

#include <memory>

#include "arrays.h"
#include "topics.h"

namespace hair::python {

namespace {

/// One stay in a `with thread_limit(n)`. Stays need not end in the order in which they began
/// (generators, tasks of asyncio), nor in the thread in which they began (a generator that is
/// collected), so nothing is restored at the end: a stay is over, and who looks passes it by.
struct Stay {
  int threads;
  std::shared_ptr<const Stay> outer;
  bool over = false;  // read and written with Python's lock
};
using StayPtr = std::shared_ptr<const Stay>;

// Of Python's contextvars: every thread and every task of asyncio has its own value, a capsule of
// a StayPtr. Never freed: calls may come until the interpreter ends.
PyObject* innermost = nullptr;

StayPtr innermostStay() {
  PyObject* value = nullptr;
  if (PyContextVar_Get(innermost, nullptr, &value) != 0) throw py::error_already_set();
  if (!value) return nullptr;
  StayPtr stay = *py::reinterpret_steal<py::capsule>(value).get_pointer<StayPtr>();
  while (stay && stay->over) stay = stay->outer;
  return stay;
}

/// thread_limit: no more than a number. The library's own ThreadLimit lives inside single calls.
class Limit {
 public:
  explicit Limit(int threads) : threads_(threads) {
    // Out of range is said now, not at `with`.
    const ThreadLimit checked(threads);
  }
  ~Limit() {
    if (stay_) stay_->over = true;
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

  void enter() {
    if (stay_) throw std::runtime_error("thread_limit: entered twice; make another one");
    const auto stay = std::make_shared<Stay>(Stay{threads_, innermostStay()});
    const py::capsule value = capsuleOf(StayPtr(stay));
    const auto token = py::reinterpret_steal<py::object>(PyContextVar_Set(innermost, value.ptr()));
    if (!token) throw py::error_already_set();
    stay_ = stay;
  }
  void exit() {
    if (!stay_) throw std::runtime_error("thread_limit: left, but not entered");
    stay_->over = true;
    stay_.reset();
  }
  int threads() const { return threads_; }

 private:
  int threads_;
  std::shared_ptr<Stay> stay_{};
};

}  // namespace

std::optional<int> threadsAllowed() {
  const StayPtr stay = innermostStay();
  return stay ? std::optional(stay->threads) : std::nullopt;
}

void bindThreads(py::module_& m) {
  innermost = PyContextVar_New("libhair.thread_limit", nullptr);
  if (!innermost) throw py::error_already_set();
  m.def(
      "thread_count", [] { return withoutLock(&threadCount); },
      "Threads that a call made here may use.");
  py::class_<Limit>(m, "thread_limit",
                    R"(with thread_limit(n): calls of this Python thread use n threads.

0: as many as the machine has. A task of asyncio has limits of its own, and those in which it was
made. The one that was entered last and not left yet holds. Results have the same bits for any number
of threads.)")
      .def(py::init<int>(), py::arg("threads"), "threads: 0 to 1024.")
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
        return "thread_limit(" + std::to_string(limit.threads()) + ")";
      });
}

}  // namespace hair::python

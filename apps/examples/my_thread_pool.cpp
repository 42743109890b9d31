// The library on threads of one's own: an engine's job system instead of oneTBB.
//
//   example_my_thread_pool
//
// Look at: a pool is two functions; a scope object makes all that this thread asks of the library
// run on it; and the state hash is the same on any threads. With one thread no pool is asked. (This
// pool makes its threads anew for each loop. A real one keeps them, and is faster.)
#include <atomic>
#include <cstdio>
#include <optional>
#include <thread>
#include <vector>

#include <libhair/hair.h>

namespace {

class MyPool : public hair::ThreadPool {
 public:
  explicit MyPool(int threads) : threads_(threads) {}

  int threadCount() const override { return threads_; }

  // Does tasks 0 to taskCount - 1, in any order, and returns when the last is done.
  void run(std::size_t taskCount, const Tasks& tasks) override {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < taskCount; i = next++) tasks(i);
    };
    std::vector<std::jthread> helpers;
    for (int t = 1; t < threads_; ++t) helpers.emplace_back(work);
    work();
    ran += taskCount;
  }

  std::size_t ran = 0;

 private:
  int threads_;
};

// Ten frames of hair in the wind.
std::uint64_t danced(const hair::Groom& groom, const hair::MeshSdf& head) {
  hair::FrameSettings settings;
  settings.wind.velocity = {3, 0, 1};
  hair::Simulation simulation(hair::borrowed(groom), settings, {}, hair::borrowed(head));
  for (int f = 0; f < 10; ++f) simulation.step({}, 1.0f / 60);
  return hair::pictureHash(simulation.hair());
}

}  // namespace

int main() {
  const hair::MeshSdf head(hair::builtinHead().mesh);
  const hair::Groom groom = hair::makeGroom(hair::styleSettings(hair::Style::Smooth), head);

  const std::uint64_t expected = danced(groom, head);
  std::printf("the library's own %d threads  %016llx\n", hair::threadCount(),
              static_cast<unsigned long long>(expected));
  bool same = true;
  for (const int threads : {1, 3, 7}) {
    MyPool pool(threads);
    const hair::ThreadPoolScope scope(pool);
    const std::uint64_t hash = danced(groom, head);
    std::printf("my pool, %d threads, %5zu tasks  %016llx\n", threads, pool.ran,
                static_cast<unsigned long long>(hash));
    same = same && hash == expected;
  }
  std::puts(same ? "the same bits" : "NOT the same bits");
  return same ? 0 : 1;
}

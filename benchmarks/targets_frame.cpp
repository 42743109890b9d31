// Rows about whole frames: body, guides, wisps, self-collision, shadows, shading; all but drawing.

#include <benchmarks/target_rows.h>

#include <cstdlib>
#include <utility>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <benchmarks/timing.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

void dance(Player& player, int frames, std::vector<double>& seconds) {
  for (int f = 0; f < frames; ++f) seconds.push_back(secondsOf([&] { player.step(); }));
}

double heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

// What is freed with the hair and its groom, but for the maps.
double bytesBesideTheMaps(Scene& scene) {
  double held = 0;
  {
    const Groom groom = std::move(scene.character->groom);
    Hair hair = std::move(scene.player.hair);
    hair.maps = std::vector<DensityMap>();
    hair.repulsion.density = DensityGrid();
    held = heapBytes();
  }
  return held - heapBytes();
}

// Peak memory of this program run again with an argument, bytes; 0: it did not run.
double peakBytesOf(const char* argument) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/proc/self/exe", "hair-bench", argument, nullptr);
    _exit(1);
  }
  int status = 0;
  struct rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) return 0;
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

void addMemoryRows(TargetRun& run) {
  const char* name = "peak memory of the default demo without drawing";
  if (const double bytes = peakBytesOf("--demo"); bytes > 0)
    run.table.row(name, 1e-6 * bytes, atMost(100), "MB");
  else
    run.table.missing(name, atMost(100), "MB", "it did not run");
}

void addFrameRows(TargetRun& run) {
  Player& player = run.scene(smoothScene()).player;
  player.log = {};
  std::vector<double> seconds;
  dance(player, run.repeats(600), seconds);
  const double selfCollision =
      player.log.milliseconds(Stage::SelfCollision, Stage::SelfCollision, 0.5);
  run.table.row("whole frame; smooth; dancing", 1 / median(seconds), atLeast(500), "frames/s");
  run.table.row("self-collision of a whole frame; smooth", 0.1 * selfCollision / median(seconds),
                atMost(2.5), "%");
  // The paper's deposit: how much of the time is spent on the default's accuracy.
  const Deposit deposit = std::exchange(player.settings.map.deposit, Deposit::Points);
  seconds.clear();
  dance(player, run.repeats(600), seconds);
  player.settings.map.deposit = deposit;
  run.table.row("whole frame; smooth; dancing; deposit of the paper (Points)", 1 / median(seconds),
                atLeast(500), "frames/s");
}

void addThreadRows(TargetRun& run) {
  Player& player = run.scene(millionScene()).player;
  std::vector<double> one, two;
  for (int round = 0; round < run.repeats(4); ++round)
    for (const int threads : {1, 2}) {
      const ThreadLimit limit(threads);
      player.step();
      dance(player, 8, threads == 1 ? one : two);
    }
  run.table.row("whole frame; 1 M segments; two threads", 1 / median(two), kNoBound, "frames/s");
  run.table.row("whole frame; 1 M segments; one thread / two threads", median(one) / median(two),
                atLeast(1.7), "x");
}

void addManyRows(TargetRun& run) {
  Scene& scene = run.scene(manyScene());
  const auto points = static_cast<double>(scene.character->groom.pointCount());
  std::vector<double> seconds;
  dance(scene.player, run.repeats(60), seconds);
  run.table.row("whole frame; 100 K strands of 16 segments on 10 K guides", 1 / median(seconds),
                atLeast(60), "frames/s");
  const ProfileLog& log = scene.player.log;
  for (const Stage stage : {Stage::Guides, Stage::Wisps, Stage::SelfCollision, Stage::Deposit,
                            Stage::Transmittance, Stage::Filter, Stage::Shade})
    run.table.row(text("  of it ", stageName(stage)), log.milliseconds(stage, stage, 0.5), kNoBound,
                  "ms");
  // The last thing that is done with this scene.
  run.table.row("memory a drawn point beside the maps; 100 K strands on 10 K guides",
                bytesBesideTheMaps(scene) / points, atMost(64), "B");
  run.scenes = {};
}

}  // namespace hair::bench

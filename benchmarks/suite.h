#pragma once

#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include <benchmarks/scenes.h>
#include <benchmarks/timing.h>

/// The benchmarks, named group/what/how. `scenes` must outlive their run.
namespace hair::bench {

/// stage/SCENE/STAGE and shadow/SCENE/PASS: what every stage of a frame takes beside its floor.
void registerStages(Scenes& scenes);
/// threads/, strands/, points/, cells/ and sets/WHAT/X: what time goes with.
void registerScaling(Scenes& scenes);
/// peers/WORK/WHO: other people's software.
void registerPeers(Scenes& scenes);

/// Runs `work` once an iteration; it returns its own seconds. The mean.
template <class Work>
double meanSeconds(benchmark::State& state, Work&& work) {
  double sum = 0;
  for (auto _ : state) {
    const double seconds = work();
    state.SetIterationTime(seconds);
    sum += seconds;
  }
  return sum / static_cast<double>(state.iterations());
}

/// Beside a time: floor_ms, the least that moving so many bytes takes; over_floor, how many times
/// that the mean `seconds` are; copy_GBps, the bandwidth that says so, of as many threads as there
/// are now. All benchmarks have the same counters, as CSV wants it.
void setFloor(benchmark::State& state, double bytes, double seconds);

/// Whole frames, one an iteration.
void runFrames(benchmark::State& state, Scene& scene);
/// Whole shadow passes with the scene's settings and so many cells in the same extent.
void runShadows(benchmark::State& state, const Scene& scene, int cells);

/// How one benchmark is asked for: milliseconds, that the work tells itself.
template <class Work>
benchmark::internal::Benchmark* add(const std::string& name, Work&& work) {
  return benchmark::RegisterBenchmark(name.c_str(), std::forward<Work>(work))
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime();
}

}  // namespace hair::bench

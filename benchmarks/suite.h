#pragma once

#include <string>

#include <benchmark/benchmark.h>

#include <benchmarks/scenes.h>

/// The benchmarks, named group/what/how. `scenes` must outlive their run.
namespace hair::bench {

/// stage/SCENE/STAGE and shadow/SCENE/PASS: what every stage of a frame takes beside its floor.
void registerStages(Scenes& scenes);
/// threads/, strands/, points/, cells/ and sets/WHAT/X: what time goes with.
void registerScaling(Scenes& scenes);
/// peers/WORK/WHO: other people's software.
void registerPeers(Scenes& scenes);

/// Beside a time: floor_ms, the least that moving so many bytes takes; over_floor, how many times
/// that was taken; copy_GBps, the bandwidth that says so, of as many threads as there are now. All
/// benchmarks have the same counters, as CSV wants it.
void setFloor(benchmark::State& state, double bytes);

/// Whole frames, one an iteration, in manual time.
void runFrames(benchmark::State& state, Scene& scene);
/// Whole shadow passes with the scene's settings and so many cells in the same extent.
void runShadows(benchmark::State& state, const Scene& scene, int cells);

/// How one benchmark is asked for: milliseconds of real time.
template <class Work>
benchmark::internal::Benchmark* add(const std::string& name, Work&& work) {
  return benchmark::RegisterBenchmark(name.c_str(), std::forward<Work>(work))
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}
/// The same, in time that the work tells itself, so many iterations.
template <class Work>
benchmark::internal::Benchmark* addFrames(const std::string& name, int iterations, Work&& work) {
  return benchmark::RegisterBenchmark(name.c_str(), std::forward<Work>(work))
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(iterations);
}

}  // namespace hair::bench

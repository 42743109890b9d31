// From a hair mesh to styled strands, each pass alone: 12 x 12 bundles of five layers, 32 points a
// strand. Arguments: threads, strands.

#include <cstdint>

#include <benchmark/benchmark.h>

#include <libhair/core/parallel.h>
#include <libhair/hair_mesh/grow.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

constexpr std::uint32_t kPoints = 32;

const HairMesh& mesh() {
  static const HairMesh bent = [] {
    HairMesh m = test::stack(test::gridScalp(12, 12), 4, {0, 0.05f, 0});
    for (std::size_t k = 1; k < m.layers.size(); ++k)
      for (glm::vec3& p : m.layers[k].positions)
        p += 0.006f * static_cast<float>(k * k) * glm::vec3(1, -0.6f, 0.3f);
    return m;
  }();
  return bent;
}

StylingSettings allOfIt() {
  StylingSettings s;
  s.lengthVariation = 0.2f;
  s.clump = 0.5f;
  s.curlRadius = 0.005f;
  s.noise = 0.005f;
  s.frizz = 0.001f;
  return s;
}

RootSettings rootSettings(const benchmark::State& state) {
  return {.strands = static_cast<std::uint32_t>(state.range(1))};
}

void done(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

void place(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(placeRoots(mesh(), rootSettings(state)));
  done(state);
}

// What an edit of places costs, without styling.
void trace(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const HairMeshRoots roots = placeRoots(mesh(), rootSettings(state));
  StrandSet strands;
  for (auto _ : state) traceStrands(mesh(), roots, kPoints, strands);
  done(state);
}

void styleAll(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const HairMeshRoots roots = placeRoots(mesh(), rootSettings(state));
  StrandSet traced, strands;
  traceStrands(mesh(), roots, kPoints, traced);
  for (auto _ : state) {
    state.PauseTiming();
    strands = traced;
    state.ResumeTiming();
    style(mesh(), roots, allOfIt(), 1, strands);
  }
  done(state);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{1, 2}, {10'000, 100'000}})->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(place)->Apply(sizes);
BENCHMARK(trace)->Apply(sizes);
BENCHMARK(styleAll)->Apply(sizes);

}  // namespace
}  // namespace hair

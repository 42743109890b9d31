// The passes of a shadowed picture, each alone, beside the literal reference in the same run:
// 3,226 strands, 100 K segments, in the volume of a head of hair, where nothing else is said. The
// first argument is the number of threads; a deposit or filter is its place in the enum.

#include <cmath>

#include <benchmark/benchmark.h>

#include <libhair/core/parallel.h>
#include <libhair/shade/appearance.h>
#include <libhair/shade/literal.h>
#include <libhair/shadow/literal.h>
#include <tests/shadow/fixture.h>

namespace hair {
namespace {

constexpr glm::vec3 kLight(0.5f, -0.8f, 0.35f);

const StrandSet& scene() {
  static const StrandSet strands = test::headOfHair(3226, 32);
  return strands;
}

/// As scene(), with another number of strands; the last one is kept.
const StrandSet& sceneOf(std::int64_t strandCount) {
  static StrandSet strands;
  if (static_cast<std::int64_t>(strands.strandCount()) != strandCount)
    strands = test::headOfHair(static_cast<std::uint32_t>(strandCount), 32);
  return strands;
}

int threads(const benchmark::State& state) {
  return static_cast<int>(state.range(0));
}

/// `cells` an axis in the same volume.
DensityMapSettings settingsOf(Deposit how, Filter filter, std::int64_t cells) {
  DensityMapSettings settings;
  const float extent = settings.extent();
  settings.deposit = how;
  settings.filter = filter;
  settings.cells = static_cast<int>(cells);
  settings.cellSize = extent / static_cast<float>(cells);
  settings.pointExtinction = 60;
  return settings;
}

void done(benchmark::State& state, const StrandSet& strands = scene()) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(strands.pointCount()));
}

// Arguments: threads, deposit (in the order of the enum), cells, strands.
void clearAndDeposit(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  const auto settings =
      settingsOf(static_cast<Deposit>(state.range(1)), Filter::Centred, state.range(2));
  const StrandSet& strands = sceneOf(state.range(3));
  const LightSpace light = makeLightSpace(kLight);
  DensityMap map;
  for (auto _ : state) {
    clear(map, settings, light);
    deposit(strands, {}, map);
  }
  state.counters["bricks"] = static_cast<double>(map.grid.brickCount());
  done(state, strands);
}
BENCHMARK(clearAndDeposit)
    ->ArgsProduct({{1, 2}, {0, 1, 2}, {128}, {3226}})
    ->ArgsProduct({{1, 2}, {0, 1}, {128}, {200, 32258, 51613}})
    ->ArgsProduct({{1, 2}, {0, 1}, {512}, {3226, 32258}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void selfCollisionDensity(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  const DensityGridSettings settings{64, 0.02f, Deposit::Points};
  DensityGrid grid;
  for (auto _ : state) {
    clear(grid, settings);
    deposit(scene(), metresOfHair(), grid, 32);
  }
}
BENCHMARK(selfCollisionDensity)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond)->UseRealTime();

void transmittance(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  DensityMap map;
  test::shadow(scene(), settingsOf(Deposit::Columns, Filter::Centred, state.range(1)),
               makeLightSpace(kLight), map);
  for (auto _ : state) computeTransmittance(map);
  done(state);
}
BENCHMARK(transmittance)
    ->ArgsProduct({{1, 2}, {128, 512}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void filter(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  DensityMap map;
  test::shadow(scene(), {}, makeLightSpace(kLight), map);
  map.settings.filter = static_cast<Filter>(state.range(1));
  std::vector<float> out(scene().pointCount());
  for (auto _ : state) sampleTransmittance(map, scene().points, out);
  done(state);
}
BENCHMARK(filter)->ArgsProduct({{1, 2}, {0, 1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

// Arguments: threads, cells.
void wholePass(benchmark::State& state, Deposit how, Filter filter) {
  const ThreadLimit limit(threads(state));
  const DensityMapSettings settings = settingsOf(how, filter, state.range(1));
  const LightSpace light = makeLightSpace(kLight);
  DensityMap map;
  std::vector<float> out(scene().pointCount());
  for (auto _ : state) {
    clear(map, settings, light);
    deposit(scene(), {}, map);
    computeTransmittance(map);
    sampleTransmittance(map, scene().points, out);
  }
  done(state);
}
BENCHMARK_CAPTURE(wholePass, paper, Deposit::Points, Filter::Paper)
    ->ArgsProduct({{1, 2}, {128, 512}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(wholePass, defaults, Deposit::Columns, Filter::Centred)
    ->ArgsProduct({{1, 2}, {128, 512}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void literalPass(benchmark::State& state) {
  literal::LiteralMap map;
  map.extinction = 60;
  const LightSpace light = makeLightSpace(kLight);
  std::vector<float> out(scene().pointCount());
  for (auto _ : state) {
    literal::fillDensity(scene().points, light, map);
    literal::computeTransmittance(map);
    literal::filterTransmittance(map, scene().points, out);
  }
  done(state);
}
BENCHMARK(literalPass)->Unit(benchmark::kMillisecond)->UseRealTime();

void literalFill(benchmark::State& state) {
  literal::LiteralMap map;
  const LightSpace light = makeLightSpace(kLight);
  for (auto _ : state) literal::fillDensity(scene().points, light, map);
  done(state);
}
BENCHMARK(literalFill)->Unit(benchmark::kMillisecond)->UseRealTime();

void literalTransmittance(benchmark::State& state) {
  literal::LiteralMap map;
  literal::fillDensity(scene().points, makeLightSpace(kLight), map);
  for (auto _ : state) literal::computeTransmittance(map);
  done(state);
}
BENCHMARK(literalTransmittance)->Unit(benchmark::kMillisecond)->UseRealTime();

void literalFilter(benchmark::State& state) {
  literal::LiteralMap map;
  literal::fillDensity(scene().points, makeLightSpace(kLight), map);
  literal::computeTransmittance(map);
  std::vector<float> out(scene().pointCount());
  for (auto _ : state) literal::filterTransmittance(map, scene().points, out);
  done(state);
}
BENCHMARK(literalFilter)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What shading makes, and how: the ways are compared in one run.
enum class Makes { Colours, Radiance, Both, RadianceThenColours };

// Arguments: threads, the paper's model or the default one, Makes, strands.
void shading(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  const StrandSet& strands = sceneOf(state.range(3));
  const auto makes = static_cast<Makes>(state.range(2));
  const std::vector<float> t(strands.pointCount(), 0.5f);
  std::vector<glm::vec3> radiance(makes == Makes::Colours ? 0 : strands.pointCount());
  std::vector<std::uint32_t> colours(makes == Makes::Radiance ? 0 : strands.pointCount());
  const Light light = Light::parallel(kLight);
  const Illumination illumination{{&light, 1}, glm::vec3(0), {0, 0, 1}, t, {}};
  const Appearance appearance = state.range(1) ? KajiyaKaySettings() : KajiyaKaySettings::plain();
  for (auto _ : state) {
    if (makes == Makes::RadianceThenColours) {
      shade(strands, illumination, appearance, radiance);
      encodeSrgb(radiance, colours);
    } else {
      shade(strands, illumination, appearance, radiance, colours);
    }
  }
  done(state, strands);
}
BENCHMARK(shading)
    ->ArgNames({"threads", "full", "makes", "strands"})
    ->ArgsProduct({{1, 2}, {0, 1}, {0, 1, 2, 3}, {3226}})
    ->ArgsProduct({{1, 2}, {1}, {0, 1, 2, 3}, {33500}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void literalShading(benchmark::State& state) {
  const std::vector<float> t(scene().pointCount(), 0.5f);
  std::vector<glm::vec3> radiance(scene().pointCount());
  const Light light = Light::parallel(kLight);
  for (auto _ : state)
    literal::shade(scene(), {{&light, 1}, glm::vec3(0), {0, 0, 1}, t, {}}, {}, radiance);
  done(state);
}
BENCHMARK(literalShading)->Unit(benchmark::kMillisecond)->UseRealTime();

// Shadows and colours under several lights, each with its map: the time goes with their number.
// Second argument: lights; third: 0 parallel, 1 at points.
void lights(benchmark::State& state) {
  const ThreadLimit limit(threads(state));
  const std::size_t n = scene().pointCount(), count = static_cast<std::size_t>(state.range(1));
  const glm::vec3 pivot(0);
  std::vector<Light> all;
  for (std::size_t l = 0; l < count; ++l) {
    const float a = 1.5708f * static_cast<float>(l);
    const glm::vec3 way = glm::normalize(glm::vec3(std::sin(a), -0.8f, std::cos(a)));
    all.push_back(state.range(2) ? Light::point(pivot - 1.5f * way) : Light::parallel(way));
  }
  std::vector<DensityMap> maps(count);
  std::vector<float> t(count * n);
  std::vector<std::uint32_t> out(n);
  for (auto _ : state) {
    for (std::size_t l = 0; l < count; ++l) {
      clear(maps[l], {}, lightSpaceOf(all[l], pivot));
      deposit(scene(), {}, maps[l]);
      computeTransmittance(maps[l]);
      sampleTransmittance(maps[l], scene().points, std::span(t).subspan(l * n, n));
    }
    shade(scene(), {all, pivot, {0, 0, 1}, t, {}}, {}, {}, out);
  }
  done(state);
}
BENCHMARK(lights)
    ->ArgsProduct({{1, 2}, {1, 2, 4}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace hair

// Rows about the shadow pass: clear, deposit, transmittance, filter.

#include <benchmarks/target_rows.h>

#include <apps/common/svg.h>
#include <benchmarks/shadow_pass.h>
#include <benchmarks/timing.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/truth.h>

namespace hair::bench {

namespace {

// Adds times of `runs` calls on so many threads, after one that warms up.
template <class Work>
void time(int threads, int runs, Work&& work, std::vector<double>& seconds) {
  const ThreadLimit limit(threads);
  work();
  for (int i = 0; i < runs; ++i) seconds.push_back(secondsOf(work));
}

struct Against {
  double literal, two, one;  // seconds
};

// In turns, so that a machine that slows down slows all alike.
Against timeAgainstLiteral(const TargetRun& run, const Scene& scene, Filter filter) {
  const DensityMapSettings settings = paperSettings(scene, filter);
  ShadowPass pass(scene, settings);
  LiteralPass literal(scene, settings);
  std::vector<double> slow, two, one;
  for (int round = 0; round < run.repeats(12); ++round) {
    time(1, 1, [&] { literal.run(); }, slow);
    time(2, 10, [&] { pass.run(); }, two);
    time(1, 10, [&] { pass.run(); }, one);
  }
  return {median(slow), median(two), median(one)};
}

double millisecondsOf(const TargetRun& run, ShadowPass& pass) {
  return 1e3 * medianSeconds(run.repeats(25), [&] { pass.run(); });
}

DensityMapSettings withCells(DensityMapSettings settings, int cells) {
  settings.cellSize = settings.extent() / static_cast<float>(cells);
  settings.cells = cells;
  return settings;
}

}  // namespace

void addShadowRows(TargetRun& run) {
  const Scene& scene = run.scene(smoothScene());
  const Against centred = timeAgainstLiteral(run, scene, Filter::Centred);
  run.table.row("literal shadow pass; smooth 128^3; one thread", 1e3 * centred.literal, kNoBound,
                "ms");
  run.table.row("shadow pass Points Centred; smooth 128^3; two threads", 1e3 * centred.two,
                kNoBound, "ms");
  run.table.row("literal / shadow pass Points Centred; two threads", centred.literal / centred.two,
                atLeast(60), "x");
  run.table.row("literal / shadow pass Points Centred; one thread", centred.literal / centred.one,
                atLeast(30), "x");
  const Against paper = timeAgainstLiteral(run, scene, Filter::Paper);
  run.table.row("literal / shadow pass Points Paper; two threads", paper.literal / paper.two,
                kNoBound, "x");
  run.table.row("literal / shadow pass Points Paper; one thread", paper.literal / paper.one,
                kNoBound, "x");
}

void addErrorRows(TargetRun& run) {
  const Scene& scene = run.scene(smoothScene());
  const Fibre& fibre = scene.character->groom.fibre;
  const DensityMapSettings settings = paperSettings(scene, Filter::Centred);
  const auto points = chooseSamplePoints(scene.strands, run.quick ? 50 : 3000, 1);
  TruthSettings how;
  how.footprint = settings.cellSize;
  how.rays = run.quick ? 8 : 512;
  const auto tracer = makeGridTracer(scene.strands, fibre);
  const LightSpace light = makeLightSpace(scene.player.settings.lights.front().direction);
  const Truth truth = exactTransmittance(*tracer, fibre, light, points, how);
  const auto errorOf = [&](auto&& pass) {
    pass.run();
    std::vector<float> measured;
    for (const SamplePoint& point : points) measured.push_back(pass.transmittance[point.point]);
    return errorFigures(measured, truth).meanAbsolute.value;
  };
  const double literal = errorOf(LiteralPass(scene, settings));
  const double own = errorOf(ShadowPass(scene, settings));
  run.table.row("mean error of the literal shadow pass against the truth", literal, kNoBound, "");
  run.table.row("mean error of the shadow pass Points Centred", own, kNoBound, "");
  run.table.row("mean error; shadow pass Points Centred / literal", own / literal, atMost(1), "x");
  run.table.row("mean error of the shadow pass as in a frame",
                errorOf(ShadowPass(scene, scene.player.settings.map)), kNoBound, "");
}

void addCellRows(TargetRun& run) {
  const Scene& scene = run.scene(smoothScene());
  const auto grow = [&](const DensityMapSettings& settings) {
    ShadowPass coarse(scene, withCells(settings, 128)), fine(scene, withCells(settings, 512));
    return millisecondsOf(run, fine) / millisecondsOf(run, coarse);
  };
  run.table.row("shadow pass Points Centred; 512^3 / 128^3",
                grow(paperSettings(scene, Filter::Centred)), atMost(2.5), "x");
  run.table.row("shadow pass as in a frame; 512^3 / 128^3", grow(scene.player.settings.map),
                kNoBound, "x");
}

void addFloorRows(TargetRun& run) {
  const Scene& scene = run.scene(millionScene());
  ShadowPass pass(scene, paperSettings(scene, Filter::Centred));
  const double milliseconds = millisecondsOf(run, pass);
  const double bytes = pass.leastBytes(), bandwidth = copyBandwidth(bytes);
  run.table.comment(text("floor: ", brief(1e-6 * bytes), " MB at ", brief(1e-9 * bandwidth),
                         " GB/s, ", brief(1e3 * bytes / bandwidth), " ms"));
  run.table.row("shadow pass Points Centred; 1 M segments", milliseconds, kNoBound, "ms");
  run.table.row("shadow pass Points Centred; 1 M segments / its memory-bound floor",
                1e-3 * milliseconds * bandwidth / bytes, atMost(3), "x");
}

}  // namespace hair::bench

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/measure/shadow/cost_model.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/head.h>
#include <libhair/model/resample.h>
#include <libhair/model/styles.h>

namespace hair {

namespace {

using Clock = std::chrono::steady_clock;

double nanosecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// The least time, as interference only adds to it.
double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

/// One method with its settings, timed on one hair.
struct Run {
  std::size_t hair;
  ShadowSettings settings;
  std::vector<double> build{}, sample{};  // nanoseconds, one per round
};

/// The runs that the coefficients are fitted to. Settings are combined so that the terms of a stage
/// are not proportional to each other.
std::vector<Run> plannedRuns(std::size_t hairs, float extent) {
  std::vector<Run> runs;
  const auto add = [&](std::size_t hair, const ShadowSettings& s) { runs.push_back({hair, s}); };
  const auto map = [&](float cell, Deposit deposit, Filter filter, float footprint) {
    DensityMapSettings s = settingsForFootprint(cell, extent + 6 * cell, 512);
    s.deposit = deposit;
    s.filter = filter;
    s.footprint = footprint * s.cellSize;
    return s;
  };
  // Vary footprints independently of cells, and layers of pixels.
  constexpr float kCells[] = {1.1e-3f, 1.6e-3f, 2.3e-3f, 3e-3f};
  constexpr float kFootprints[] = {2.8f, 1, 2, 1.4f};
  for (std::size_t h = 0; h < hairs; ++h) {
    for (std::size_t c = 0; c < 4; ++c)
      add(h, map(kCells[c], Deposit::Columns, Filter::Footprint, kFootprints[(c + h) % 4]));
    for (const Deposit deposit : {Deposit::Columns, Deposit::Segments}) {
      add(h, map(h == 0 ? 5e-3f : 4e-3f, deposit, Filter::Centred, 0));
      add(h, map(h == 0 ? 2e-3f : 8e-3f, deposit, Filter::Centred, 0));
    }
    for (const float points : {1.5e-3f, 3e-3f, 6e-3f})
      add(h, map(points, Deposit::Points, Filter::Centred, 0));
    add(h, ShadowMapSettings{h == 1 ? 2e-3f : 1e-3f, h == 2 ? 6e-3f : 3e-3f, 1e-3f});
    add(h, ShadowMapSettings{h == 2 ? 3e-3f : 0.5e-3f, 3e-3f, 1e-3f});
    for (const float pixel : {1.8e-3f, 4.5e-3f}) {
      DeepOpacityMapSettings deep;
      deep.pixelSize = pixel;
      deep.layers = (h == 1) == (pixel < 3e-3f) ? 7 : 15;
      add(h, deep);
      add(h, OpacityMapSettings{pixel, (h == 1) == (pixel < 3e-3f) ? 16 : 128});
    }
    DensityClusteringSettings clusters;
    clusters.pixelSize = h == 1 ? 2e-3f : 4e-3f;
    clusters.clusters = h == 0 ? 8 : 4;
    add(h, clusters);
    DeepShadowMapSettings visibility;
    visibility.pixelSize = clusters.pixelSize;
    add(h, visibility);
  }
  return runs;
}

/// Minimises the sum of (1 - terms · x / time)² over x >= 0 by coordinate descent: sets one
/// coefficient after the other to its best value, until none changes.
CostTerms fit(const std::vector<CostTerms>& terms, const std::vector<double>& time) {
  CostTerms x{};
  for (int pass = 0; pass < 20'000; ++pass) {
    double moved = 0;
    for (std::size_t c = 0; c < kCostTerms; ++c) {
      double square = 0, product = 0;
      for (std::size_t r = 0; r < time.size(); ++r) {
        double left = 1;
        for (std::size_t k = 0; k < kCostTerms; ++k)
          if (k != c) left -= terms[r][k] * x[k] / time[r];
        const double a = terms[r][c] / time[r];
        square += a * a;
        product += a * left;
      }
      const double next = square > 0 ? std::max(product / square, 0.0) : 0.0;
      moved = std::max(moved, std::abs(next - x[c]) * std::sqrt(square));
      x[c] = next;
    }
    if (moved < 1e-9) break;
  }
  return x;
}

StrandSet inRandomOrder(StrandView strands) {
  std::vector<std::uint32_t> order(strands.strandCount());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [](std::uint32_t a, std::uint32_t b) {
    return std::pair(hashWord(a), a) < std::pair(hashWord(b), b);
  });
  StrandSet result;
  for (const std::uint32_t s : order) result.append(strands.strand(s));
  return result;
}

void timeOnce(StrandView strands, const Fibre& fibre, const LightSpace& light, Run& run,
              std::vector<float>& out) {
  const std::unique_ptr<ShadowMethod> method = makeShadowMethod(run.settings);
  method->build(strands, fibre, light);  // warms pages and caches
  Clock::time_point start = Clock::now();
  method->build(strands, fibre, light);
  run.build.push_back(nanosecondsSince(start));
  start = Clock::now();
  method->sampleStrands(strands, std::span(out).first(strands.pointCount()));
  run.sample.push_back(nanosecondsSince(start));
}

}  // namespace

MachineCosts calibrate(StrandView strands, const Fibre& fibre, int repeats) {
  require(repeats >= 1, "calibration: ", repeats, " repeats; take 1 or more");
  require(strands.strandCount() >= 2 && strands.pointCount() > 2 * strands.strandCount(),
          "calibration: ", strands.strandCount(), " strands of ", strands.pointCount(),
          " points are too few to tell costs apart; take the built-in style");
  const LightSpace light = makeLightSpace({0.45f, -0.8f, -0.4f});
  // Make three hairs in which points, segments, cells and memory are not proportional: the strands
  // in their order; in random order, which misses caches; and half of them with a third of the
  // points.
  const StrandSet shuffled = inRandomOrder(strands);
  const std::size_t perStrand = strands.pointCount() / strands.strandCount();
  const ResamplePlan plan =
      planResampling(strands, chooseStrands(strands.strandCount(), strands.strandCount() / 2),
                     std::max<std::size_t>(perStrand / 3, 2));
  const std::vector<glm::vec3> points(strands.points.begin(), strands.points.end());
  const StrandSet coarse{resample(plan, points), plan.first};
  const StrandView hairs[] = {strands, shuffled, coarse};
  std::vector<HairFeatures> features;
  for (const StrandView hair : hairs) features.push_back(hairFeatures(hair, light));
  // Time all runs, round by round.
  const glm::dvec3 size = features[0].size;
  std::vector<Run> runs =
      plannedRuns(features.size(), static_cast<float>(std::max({size.x, size.y, size.z})));
  std::vector<float> out(strands.pointCount());
  for (int round = 0; round < repeats; ++round)
    for (Run& run : runs) timeOnce(hairs[run.hair], fibre, light, run, out);

  // Fit each stage to its runs.
  MachineCosts machine;
  machine.threads = threadCount();
  for (std::size_t s = 0; s < kCostStages; ++s) {
    const auto stage = static_cast<CostStage>(s);
    std::vector<CostTerms> terms;
    std::vector<double> time;
    for (const Run& run : runs) {
      const CostStages stages = costStages(run.settings);
      if (stages.build != stage && stages.sample != stage) continue;
      terms.push_back(costTerms(stage, features[run.hair], run.settings));
      time.push_back(least(stages.build == stage ? run.build : run.sample));
    }
    machine.nanoseconds[s] = fit(terms, time);
  }
  return machine;
}

MachineCosts calibrate() {
  const Groom groom =
      makeGroom(styleSettings(Style::Smooth), MeshSdf{builtinHead().mesh, 0.004f, 0.05f});
  StrandSet strands;
  strands.first = groom.first;
  strands.points.resize(groom.pointCount());
  for (std::size_t s = 0; s < groom.strandCount(); ++s) drawAtRest(groom, s, strands.strand(s));
  return calibrate(strands, groom.fibre);
}

}  // namespace hair

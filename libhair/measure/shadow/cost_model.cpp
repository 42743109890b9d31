#include <libhair/measure/shadow/cost_model.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/density/brick_store.h>
#include <libhair/shadow/footprint.h>

namespace hair {

namespace {

// Side, in cells, of a cube of as many cells as a brick has.
const double kBrickSide = std::cbrt(brick::kCells);

double log2Of(double x) {
  return std::log2(1 + x);
}

CostTerms mapBuild(CostStage stage, const HairFeatures& hair, const DensityMapSettings& s) {
  const double cell = static_cast<double>(s.cellSize);
  const double bricks = hair.boxes.at(kBrickSide * cell), brickCells = bricks * brick::kCells;
  const double places = std::pow(s.cells, 3) / brick::kCells;
  const double missed = hair.coldShare * log2Of(brickCells * sizeof(std::uint32_t) * 1e-6);
  switch (stage) {
    case CostStage::DepositPoints:
      return {hair.points, 0, places, brickCells, hair.points * missed};
    case CostStage::DepositColumns:
      return {hair.segments, hair.pixelsCrossed(cell), places, brickCells,
              hair.pixelsCrossed(cell) * missed};
    default:
      return {hair.segments, hair.cellsCrossed(cell), places, brickCells,
              hair.cellsCrossed(cell) * missed};
  }
}

CostTerms mapSample(const HairFeatures& hair, const DensityMapSettings& s) {
  const double cell = static_cast<double>(s.cellSize);
  const double megabytes = hair.boxes.at(kBrickSide * cell) * brick::kCells * sizeof(float) * 1e-6;
  double reads = 1;
  if (s.filter == Filter::Footprint) {
    const double across = 2 * static_cast<double>(FootprintKernel(s).halfWidth) + 2;
    // Count the rows of bricks that a row of weights crosses, on average over where it begins.
    reads = across * (1 + (across - 1) / brick::kY);
  }
  return {hair.points, hair.points * reads, hair.points * log2Of(megabytes),
          hair.points * reads * log2Of(megabytes),
          hair.points * hair.coldShare * log2Of(megabytes)};
}

struct ImageShape {
  double pixels, fragments, perPixel;  // perPixel: mean fragments of a pixel that has any
};
ImageShape imageShape(const HairFeatures& hair, float pixelSize) {
  const double size = static_cast<double>(pixelSize);
  const double fragments = hair.pixelsCrossed(size);
  return {(hair.size.y / size + 3) * (hair.size.z / size + 3), fragments,
          fragments / hair.pixels.at(size)};
}

CostTerms imageBuild(const HairFeatures& hair, float pixelSize, double words) {
  const ImageShape image = imageShape(hair, pixelSize);
  return {hair.segments, image.fragments, image.pixels * words,
          image.fragments * hair.coldShare *
              log2Of(image.pixels * words * sizeof(std::uint32_t) * 1e-6),
          0};
}

CostTerms listsBuild(const HairFeatures& hair, float pixelSize, double clusters) {
  const ImageShape image = imageShape(hair, pixelSize);
  return {hair.segments, image.fragments, image.fragments * log2Of(image.perPixel),
          image.fragments * clusters,
          image.fragments * hair.coldShare * log2Of(image.fragments * 8e-6)};
}

struct Stages {
  CostStages operator()(const DensityMapSettings& s) const {
    const CostStage build = s.deposit == Deposit::Points    ? CostStage::DepositPoints
                            : s.deposit == Deposit::Columns ? CostStage::DepositColumns
                                                            : CostStage::DepositSegments;
    return {build,
            s.filter == Filter::Footprint ? CostStage::SampleFootprint : CostStage::SampleCells};
  }
  CostStages operator()(const ShadowMapSettings&) const {
    return {CostStage::ShadowMapBuild, CostStage::ShadowMapSample};
  }
  CostStages operator()(const OpacityMapSettings&) const {
    return {CostStage::OpacityMapBuild, CostStage::OpacityMapSample};
  }
  CostStages operator()(const DeepOpacityMapSettings&) const {
    return {CostStage::DeepOpacityMapBuild, CostStage::DeepOpacityMapSample};
  }
  CostStages operator()(const DensityClusteringSettings&) const {
    return {CostStage::ClusteringBuild, CostStage::ClusteringSample};
  }
  CostStages operator()(const DeepShadowMapSettings&) const {
    return {CostStage::DeepShadowMapBuild, CostStage::DeepShadowMapSample};
  }
};

struct Terms {
  const HairFeatures& hair;
  CostStage stage;
  bool build;

  CostTerms operator()(const DensityMapSettings& s) const {
    return build ? mapBuild(stage, hair, s) : mapSample(hair, s);
  }
  CostTerms operator()(const ShadowMapSettings& s) const {
    if (build) return imageBuild(hair, s.pixelSize, 1);
    const double radius = static_cast<double>(s.filterRadius / s.pixelSize);
    return {hair.points, hair.points * (2 * radius + 1), hair.points * 3.14159 * radius * radius, 0,
            0};
  }
  CostTerms operator()(const OpacityMapSettings& s) const {
    return build ? imageBuild(hair, s.pixelSize, s.slices) : sampleWords(s.pixelSize, s.slices);
  }
  CostTerms operator()(const DeepOpacityMapSettings& s) const {
    return build ? imageBuild(hair, s.pixelSize, s.layers + 1)
                 : sampleWords(s.pixelSize, s.layers + 1);
  }
  CostTerms operator()(const DensityClusteringSettings& s) const {
    if (build) return listsBuild(hair, s.pixelSize, s.clusters);
    return {hair.points, hair.points * s.clusters, 0, 0, 0};
  }
  CostTerms operator()(const DeepShadowMapSettings& s) const {
    if (build) return listsBuild(hair, s.pixelSize, 0);
    const double perPixel = imageShape(hair, s.pixelSize).perPixel;
    return {hair.points, hair.points * log2Of(perPixel), 0, 0, 0};
  }
  CostTerms sampleWords(float pixelSize, double words) const {
    const double megabytes =
        imageShape(hair, pixelSize).pixels * words * sizeof(std::uint32_t) * 1e-6;
    return {hair.points, hair.points * log2Of(megabytes), 0, 0, 0};
  }
};

bool builds(CostStage stage) {
  switch (stage) {
    case CostStage::SampleCells:
    case CostStage::SampleFootprint:
    case CostStage::ShadowMapSample:
    case CostStage::OpacityMapSample:
    case CostStage::DeepOpacityMapSample:
    case CostStage::ClusteringSample:
    case CostStage::DeepShadowMapSample:
      return false;
    default:
      return true;
  }
}

double milliseconds(const MachineCosts& machine, CostStage stage, const CostTerms& terms) {
  double sum = 0;
  for (std::size_t t = 0; t < kCostTerms; ++t)
    sum += machine.nanoseconds[static_cast<std::size_t>(stage)][t] * terms[t];
  return sum * 1e-6;
}

}  // namespace

CostStages costStages(const ShadowSettings& settings) {
  return std::visit(Stages{}, settings);
}

CostTerms costTerms(CostStage stage, const HairFeatures& hair, const ShadowSettings& settings) {
  return std::visit(Terms{hair, stage, builds(stage)}, settings);
}

PredictedTime predictTime(const MachineCosts& machine, const HairFeatures& hair,
                          const ShadowSettings& settings) {
  const CostStages stages = costStages(settings);
  return {milliseconds(machine, stages.build, costTerms(stages.build, hair, settings)),
          milliseconds(machine, stages.sample, costTerms(stages.sample, hair, settings))};
}

std::string costText(const MachineCosts& machine) {
  static constexpr const char* kNames[kCostStages] = {"density map points build",
                                                      "density map columns build",
                                                      "density map segments build",
                                                      "density map cells sample",
                                                      "density map footprint sample",
                                                      "shadow map build",
                                                      "shadow map sample",
                                                      "opacity map build",
                                                      "opacity map sample",
                                                      "deep opacity map build",
                                                      "deep opacity map sample",
                                                      "density clustering build",
                                                      "density clustering sample",
                                                      "deep shadow map build",
                                                      "deep shadow map sample"};
  std::ostringstream out;
  for (std::size_t s = 0; s < kCostStages; ++s) {
    out << kNames[s] << ':';
    for (const double ns : machine.nanoseconds[s]) out << ' ' << ns;
    out << " ns\n";
  }
  return out.str();
}

}  // namespace hair

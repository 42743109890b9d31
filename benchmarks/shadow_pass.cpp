#include <benchmarks/shadow_pass.h>

#include <libhair/light/light.h>
#include <libhair/shadow/density_map.h>

namespace hair::bench {

namespace {

LightSpace lightOf(const Scene& scene) {
  const Player& player = scene.player;
  return lightSpaceOf(player.settings.lights.front(), player.hair.pivot());
}

}  // namespace

DensityMapSettings paperSettings(const Scene& scene, Filter filter) {
  DensityMapSettings settings = scene.player.settings.map;
  settings.deposit = Deposit::Points;
  settings.filter = filter;
  DensityMap map;
  clear(map, settings, lightOf(scene));
  deposit(scene.strands, scene.character->groom.fibre, map);
  settings.pointExtinction = map.grid.quantum / settings.cellSize;
  return settings;
}

ShadowPass::ShadowPass(StrandView strands, const Fibre& fibre, const LightSpace& light,
                       const DensityMapSettings& settings_)
    : settings(settings_),
      transmittance(strands.pointCount()),
      strands_(strands),
      fibre_(fibre),
      light_(light) {}

ShadowPass::ShadowPass(const Scene& scene, const DensityMapSettings& settings_)
    : ShadowPass(scene.strands, scene.character->groom.fibre, lightOf(scene), settings_) {}

void ShadowPass::run() {
  clear(map, settings, light_);
  deposit(strands_, fibre_, map);
  computeTransmittance(map);
  sampleStrandTransmittance(map, strands_, transmittance);
}

double ShadowPass::leastBytes() const {
  Counts counts;
  counts.strands = static_cast<double>(strands_.strandCount());
  counts.points = static_cast<double>(strands_.pointCount());
  counts.bricks = static_cast<double>(map.grid.brickCount());
  return bench::leastBytes(Stage::Deposit, Stage::Filter, counts);
}

LiteralPass::LiteralPass(const Scene& scene, const DensityMapSettings& settings)
    : transmittance(scene.strands.pointCount()), strands_(scene.strands), light_(lightOf(scene)) {
  map.cells = settings.cells;
  map.cellSize = settings.cellSize;
  map.extinction = settings.pointExtinction;
}

void LiteralPass::run() {
  literal::fillDensity(strands_.points, light_, map);
  literal::computeTransmittance(map);
  literal::filterTransmittance(map, strands_.points, transmittance);
}

}  // namespace hair::bench

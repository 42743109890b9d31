#include <libhair/simulation/stages.h>

#include <algorithm>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/density/grid_cells.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>
#include <libhair/simulation/frame.h>

namespace hair {

namespace {

std::int64_t guidePointsOf(const Hair& hair) {
  return static_cast<std::int64_t>(hair.guides.guideCount() * hair.guides.pointsPerGuide());
}

std::int64_t pointsOf(const Hair& hair) {
  return static_cast<std::int64_t>(hair.wisps.points.size());
}

// Strands that self-collision splats: the same at every level, so that a level change does not move
// hair.
StrandView countedStrands(const RepulsionSettings& settings, Hair& hair) {
  if (hair.wisps.drawn.first.empty()) return hair.strands();
  StrandSet& counted = HairScratch::counted(hair);
  drawEvery(strideCounted(hair.groom->strandCount(), settings), hair.wisps, counted);
  return counted;
}

// Deposits the drawn hair in the light's map, and the body if settings.bodyShadow.
void fillMap(const DrawnHair& drawn, const Light& light, const DensityMapSettings& cells,
             const FrameSettings& settings, const Hair& hair, DensityMap& map) {
  clear(map, cells, lightSpaceOf(light, hair.pivot()));
  deposit(drawn, map);
  if (!settings.bodyShadow) return;
  if (hair.head) occlude(*hair.head, hair.worldFromHead, map);
  occlude(hair.capsules, map);
}

// The hair's largest extent along an axis of the map.
int extentInCells(const DensityMap& map) {
  const glm::ivec3 size = map.grid.upper - map.grid.lower;
  return std::max({size.x, size.y, size.z}) + 1;
}

// fillMap, with larger cells where the hair would wrap around the map. Cells grow in steps, so that
// small motion keeps their size; they depend on this frame's hair alone.
void fillFittingMap(const DrawnHair& drawn, const Light& light, const FrameSettings& settings,
                    const Hair& hair, DensityMap& map) {
  constexpr float kStep = 1.25f;
  constexpr int kMostRounds = 4;
  // Hair around or behind a point light fits into no map: keep the cell size of the settings.
  constexpr float kMostAtPoint = 4;
  DensityMapSettings cells = mapAt(hair.wisps.drawn.level, settings.map);
  fillMap(drawn, light, cells, settings, hair, map);
  for (int round = 0; map.aliased() && round < kMostRounds; ++round) {
    float larger = kStep;
    const float needed =
        static_cast<float>(extentInCells(map)) / static_cast<float>(map.settings.cells - 1);
    if (light.kind == Light::Kind::Point && needed > kMostAtPoint) return;
    while (larger < needed) larger *= kStep;
    cells.cellSize = std::min(larger * cells.cellSize, 1e6f);
    fillMap(drawn, light, cells, settings, hair, map);
  }
}

}  // namespace

void requireLevel(const Hair& hair) {
  if (hair.level == hair.wisps.drawn.level) return;
  validate(hair.level);
  require(hair.detail,
          "level of detail: Hair::level is set, but Hair::detail is null; make a "
          "GroomDetail of the groom");
}

void applyLevel(Hair& hair) {
  if (hair.level == hair.wisps.drawn.level) return;
  requireLevel(hair);
  setLevel(*hair.detail, hair.level, hair.wisps);
  hair.visibility.clear();  // it had one value for each old point
}

void learnRestDensity(const FrameSettings& settings, Hair& hair) {
  Repulsion& repulsion = hair.repulsion;
  if (!settings.selfCollision) {
    // Both would be stale when self-collision is switched on again.
    std::fill(repulsion.push.begin(), repulsion.push.end(), LaneVec3{});
    repulsion.windShare.clear();
    return;
  }
  const std::uint32_t key = restDensityKey(settings.repulsion);
  if (!repulsion.allowed.empty() && repulsion.learntWith == 0) repulsion.learntWith = key;
  if (!repulsion.allowed.empty() && repulsion.learntWith == key) return;
  const GuideStrands atRest(*hair.groom, settings.guides, hair.worldFromHead, hair.head);
  const Wisps drawn(*hair.groom, atRest, hair.wisps.settings, hair.head);
  Repulsion learnt;
  allowRestDensity(drawn.strands(), hair.groom->fibre, atRest, settings.repulsion, learnt);
  // The hair is in motion: keep the current push, turn and waiting time.
  repulsion.density = std::move(learnt.density);
  repulsion.allowed = std::move(learnt.allowed);
  repulsion.learntWith = learnt.learntWith;
  if (repulsion.push.empty()) repulsion.push = std::move(learnt.push);
}

void moveGuides(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
                FrameProfile& profile) {
  const StageTimer timer(profile, Stage::Guides, guidePointsOf(hair));
  if (!hair.body().sameCounts(body)) changeColliders(body, settings, hair);
  GuideMotion motion{body.worldFromHead, body.capsules, hair.capsules,
                     hair.head,          settings.wind, hair.time};
  motion.scenery = body.scenery;
  motion.sceneryBefore = {hair.planes, hair.meshes};
  if (settings.selfCollision) {
    motion.push = hair.repulsion.push;
    const bool measured = hair.repulsion.windShare.size() == hair.guides.position.size();
    if (settings.wind.occlusion > 0 && measured) motion.windShare = hair.repulsion.windShare;
  }
  stepGuides(motion, settings.guides, seconds, HairScratch::guides(hair), hair.guides);
}

void drawStrands(const BodyState& body, Hair& hair, FrameProfile& profile) {
  const StageTimer timer(profile, Stage::Wisps, pointsOf(hair));
  interpolateWisps(hair.guides, collidersOf(body, hair.head), hair.wisps);
}

void repelFromDensity(const FrameSettings& settings, float seconds, Hair& hair,
                      FrameProfile& profile) {
  if (!settings.selfCollision) return;
  const int turns = repelPasses(seconds, settings.repulsion, hair.repulsion);
  if (turns == 0) return;
  const StageTimer timer(profile, Stage::SelfCollision, guidePointsOf(hair));
  measureDensity(countedStrands(settings.repulsion, hair), hair.groom->fibre, settings.repulsion,
                 hair.repulsion.density);
  for (int i = 0; i < turns; ++i) repel(hair.guides, settings.repulsion, hair.repulsion);
  if (settings.wind.occlusion > 0) occludeWind(hair.guides, settings.wind, hair.repulsion);
}

void shadow(const FrameSettings& settings, Hair& hair, FrameProfile& profile) {
  const DrawnHair drawn = hair.wisps.drawnHair();
  const std::size_t pointCount = drawn.strands.pointCount();
  const std::int64_t points = pointsOf(hair);
  hair.maps.resize(settings.shadow ? settings.lights.size() : 0);
  hair.transmittance.resize(hair.maps.size() * pointCount);
  for (std::size_t l = 0; l < hair.maps.size(); ++l) {
    DensityMap& map = hair.maps[l];
    {
      const StageTimer timer(profile, Stage::Deposit, points);
      fillFittingMap(drawn, settings.lights[l], settings, hair, map);
    }
    {
      const auto cells = static_cast<std::int64_t>(map.grid.brickCount() * brick::kCells);
      const StageTimer timer(profile, Stage::Transmittance, cells);
      computeTransmittance(map);
    }
    const StageTimer timer(profile, Stage::Filter, points);
    sampleStrandTransmittance(map, drawn.strands,
                              std::span(hair.transmittance).subspan(l * pointCount, pointCount));
  }
}

void shade(const FrameSettings& settings, Hair& hair, FrameProfile& profile) {
  const std::size_t points = hair.wisps.points.size();
  hair.radiance.resize(settings.shade && settings.radiance ? points : 0);
  hair.colours.resize(settings.shade && settings.encode ? points : 0);
  if (!settings.shade) return;
  const StageTimer timer(profile, Stage::Shade, pointsOf(hair));
  const DrawnHair drawn = hair.wisps.drawnHair();
  shade(drawn.strands, hair.illumination(settings), settings.appearance, hair.radiance,
        hair.colours);
  if (settings.encode) fadeColours(drawn.strands.first, drawn.weights, hair.colours);
}

}  // namespace hair

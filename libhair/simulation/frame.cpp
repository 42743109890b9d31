#include <libhair/simulation/frame.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/deposit.h>
#include <libhair/guides/validate.h>
#include <libhair/shadow/filter.h>
#include <libhair/shadow/occlude.h>
#include <libhair/shadow/transmittance.h>
#include <libhair/simulation/collider_fade_in.h>
#include <libhair/simulation/scene_changes.h>

namespace hair {

ColliderState collidersOf(const BodyState& body, const MeshSdf* head) {
  return {body.worldFromHead, body.worldFromHead, body.capsules, body.capsules, head, body.scenery};
}

Hair::Hair(const Groom& groom_, const FrameSettings& settings, const BodyState& body,
           const MeshSdf* head_, const WispSettings& wispSettings)
    : groom(&groom_),
      head(head_),
      guides(groom_, settings.guides, body.worldFromHead, head_),
      wisps(groom_, guides, wispSettings, head_) {
  validate(body.capsules);
  validate(body.scenery);
  remember(body);
  if (settings.selfCollision)
    allowRestDensity(strands(), groom->fibre, guides, settings.repulsion, repulsion);
}

void Hair::remember(const BodyState& body) {
  const auto copy = []<class T>(std::span<const T> from, std::vector<T>& to) {
    if (from.data() != to.data()) to.assign(from.begin(), from.end());
  };
  worldFromHead = body.worldFromHead;
  copy(body.capsules, capsules);
  copy(body.scenery.planes, planes);
  copy(body.scenery.meshes, meshes);
}

namespace {

void takeLevel(Hair& hair) {
  if (hair.level == hair.wisps.drawn.level) return;
  require(hair.detail,
          "level of detail: Hair::level is set, but Hair::detail is null; make a "
          "GroomDetail of the groom");
  setLevel(*hair.detail, hair.level, hair.wisps);
  hair.visibility.clear();  // of other points
}

// What self-collision counts: always the same strands, or hair would move when its level changes.
StrandView feltStrands(const RepulsionSettings& settings, Hair& hair) {
  if (hair.wisps.drawn.first.empty()) return hair.strands();
  drawEvery(strideCounted(hair.groom->strandCount(), settings), hair.wisps, hair.felt);
  return hair.felt;
}

// A point of a strand that is so much wider lies in so much more of its own shadow, which no strand
// of the whole groom has.
void forgiveWidth(const Wisps& wisps, DensityMap& map) {
  if (wisps.drawn.first.empty()) return;
  map.fibreShadow *= 1 + wisps.groom->fibre.hairsPerStrand * (wisps.drawn.wider - 1);
}

}  // namespace

DensityMapSettings mapAt(const LevelOfDetail& level, const DensityMapSettings& settings) {
  if (level.cellSize <= settings.cellSize) return settings;
  DensityMapSettings coarse = settings;
  const float larger = level.cellSize / settings.cellSize;
  coarse.cellSize = level.cellSize;
  coarse.footprint *= larger;
  coarse.cells = std::max(static_cast<int>(std::ceil(static_cast<float>(settings.cells) / larger)),
                          std::min(8, settings.cells));
  return coarse;
}

void redraw(Hair& hair) {
  takeLevel(hair);
  interpolateWisps(hair.guides, collidersOf(hair.body(), hair.head), hair.wisps);
}

void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile) {
  takeLevel(hair);
  // Hair that was made without it does not know what density it has at rest.
  const bool selfCollision = settings.selfCollision && !hair.repulsion.allowed.empty();
  const auto guidePoints =
      static_cast<std::int64_t>(hair.guides.guideCount() * hair.guides.pointsPerGuide());
  const auto points = static_cast<std::int64_t>(hair.wisps.points.size());
  {
    const StageTimer timer(profile, Stage::Guides, guidePoints);
    if (!hair.body().asMany(body)) changeColliders(body, settings, hair);
    const std::span<const LaneVec3> push =
        selfCollision ? hair.repulsion.push : std::span<const LaneVec3>{};
    const bool sheltered = selfCollision && settings.wind.shelter > 0 &&
                           hair.repulsion.windShare.size() == hair.guides.position.size();
    stepGuides({body.worldFromHead,
                body.capsules,
                hair.capsules,
                hair.head,
                settings.wind,
                hair.time,
                push,
                sheltered ? hair.repulsion.windShare : std::span<const Lanes>{},
                body.scenery,
                {hair.planes, hair.meshes}},
               settings.guides, seconds, hair.workspace, hair.guides);
  }
  {
    const StageTimer timer(profile, Stage::Wisps, points);
    interpolateWisps(hair.guides, collidersOf(body, hair.head), hair.wisps);
  }
  const int turns = selfCollision ? turnsDue(seconds, settings.repulsion, hair.repulsion) : 0;
  if (turns > 0) {
    const StageTimer timer(profile, Stage::SelfCollision, guidePoints);
    measureDensity(feltStrands(settings.repulsion, hair), hair.groom->fibre, settings.repulsion,
                   hair.repulsion.density);
    for (int i = 0; i < turns; ++i) repel(hair.guides, settings.repulsion, hair.repulsion);
    if (settings.wind.shelter > 0) shelter(hair.guides, settings.wind, hair.repulsion);
  }
  hair.remember(body);
  hair.time += seconds;
  light(settings, hair, profile);
}

void light(const FrameSettings& settings, Hair& hair, FrameProfile& profile) {
  const std::size_t pointCount = hair.wisps.points.size();
  const auto points = static_cast<std::int64_t>(pointCount);
  hair.maps.resize(settings.shadow ? settings.lights.size() : 0);
  hair.transmittance.resize(hair.maps.size() * pointCount);
  for (std::size_t l = 0; l < hair.maps.size(); ++l) {
    DensityMap& map = hair.maps[l];
    {
      const StageTimer timer(profile, Stage::Deposit, points);
      clear(map, mapAt(hair.wisps.drawn.level, settings.map),
            lightSpaceOf(settings.lights[l], hair.pivot()));
      deposit(hair.strands(), hair.wisps.fibre(), map, 1, hair.wisps.drawn.weights);
      forgiveWidth(hair.wisps, map);
      if (settings.bodyShadow) {
        if (hair.head) occlude(*hair.head, hair.worldFromHead, map);
        occlude(hair.capsules, map);
      }
    }
    {
      const auto cells = static_cast<std::int64_t>(map.bricks.size() * brick::kCells);
      const StageTimer timer(profile, Stage::Transmittance, cells);
      computeTransmittance(map);
    }
    const StageTimer timer(profile, Stage::Filter, points);
    sampleStrandTransmittance(map, hair.strands(),
                              std::span(hair.transmittance).subspan(l * pointCount, pointCount));
  }
  hair.colours.resize(settings.shade ? pointCount : 0);
  if (settings.shade) {
    const StageTimer timer(profile, Stage::Shade, points);
    shadeKajiyaKay(hair.strands(), hair.illumination(settings), settings.look, hair.colours);
    fadeColours(hair.wisps, hair.colours);
  }
}

void restart(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair) {
  require(seconds >= 0 && seconds <= 3600, "restart: ", seconds,
          " s to settle are not in 0 to 3600");
  validate(body.scenery);
  FrameProfile unused{};
  FrameSettings still = settings;
  still.wind = {};
  still.shadow = still.shade = false;
  still.guides.airDrag = std::max(still.guides.airDrag, 20.0f);
  hair.guides.reset(body.worldFromHead);
  hair.repulsion.turn = 0;
  hair.repulsion.windShare.clear();
  hair.repulsion.waiting = 0;
  hair.time = 0;
  std::fill(hair.repulsion.push.begin(), hair.repulsion.push.end(), LaneVec3{});
  const int frames = static_cast<int>(std::ceil(seconds * 60));
  GrowingBody growing(body, hair.guides);
  hair.remember(frames > 0 ? growing.at(0) : body);
  if (frames == 0) redraw(hair);
  for (int i = 1; i <= frames; ++i)
    frame(growing.at(static_cast<float>(i) / static_cast<float>(frames)), still, 1.0f / 60, hair,
          unused);
  std::fill(hair.guides.velocity.begin(), hair.guides.velocity.end(), LaneVec3{});
  hair.time = 0;
}

}  // namespace hair

#include <libhair/simulation/frame.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/validate.h>
#include <libhair/simulation/collider_fade_in.h>
#include <libhair/simulation/stages.h>

namespace hair {

ColliderState collidersOf(const BodyState& body, const MeshSdf* head) {
  return {body.worldFromHead, body.worldFromHead, body.capsules, body.capsules, head, body.scenery};
}

void validate(const FrameSettings& s) {
  validateFields(s, "frame settings");
  for (const Light& light : s.lights) validate(light);
  require(s.lights.size() <= 256, "frame settings: ", s.lights.size(), " lights; at most 256");
}

DensityMapSettings fitMap(const DensityMapSettings& settings, const Groom& groom, float headSize) {
  DensityMapSettings fitted = settings;
  fitted.cellSize =
      mapExtentNeeded(longestGuide(groom), headSize) / static_cast<float>(settings.cells);
  validate(fitted);
  return fitted;
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
  worldFromHead = body.worldFromHead;
  assignSpan(body.capsules, capsules);
  assignSpan(body.scenery.planes, planes);
  assignSpan(body.scenery.meshes, meshes);
}

DensityMapSettings mapAt(const LevelOfDetail& level, const DensityMapSettings& settings) {
  validate(settings);
  if (level.cellSize <= settings.cellSize) return settings;
  DensityMapSettings coarse = settings;
  const float larger = level.cellSize / settings.cellSize;
  coarse.cellSize = level.cellSize;
  coarse.footprint = std::min(coarse.footprint * larger, 10 * coarse.cellSize);
  coarse.cells = std::max(static_cast<int>(std::ceil(static_cast<float>(settings.cells) / larger)),
                          std::min(8, settings.cells));
  return coarse;
}

std::uint64_t stateHash(const Hair& hair) {
  StateHash hash;
  hair.guides.addTo(hash);
  hash.add(std::span<const glm::vec3>(hair.wisps.points));
  return hash.value();
}

std::uint64_t pictureHash(const Hair& hair) {
  StateHash hash;
  hair.guides.addTo(hash);
  hash.add(std::span<const glm::vec3>(hair.wisps.points));
  hash.add(std::span<const float>(hair.transmittance));
  hash.add(std::span<const std::uint32_t>(hair.colours));
  return hash.value();
}

void redraw(Hair& hair) {
  applyLevel(hair);
  interpolateWisps(hair.guides, collidersOf(hair.body(), hair.head), hair.wisps);
}

void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile) {
  applyLevel(hair);
  learnRestDensity(settings, hair);
  moveGuides(body, settings, seconds, hair, profile);
  drawStrands(body, hair, profile);
  repelFromDensity(settings, seconds, hair, profile);
  hair.remember(body);
  hair.time += seconds;
  light(settings, hair, profile);
}

void light(const FrameSettings& settings, Hair& hair, FrameProfile& profile) {
  shadow(settings, hair, profile);
  shade(settings, hair, profile);
}

void restart(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair) {
  require(seconds >= 0 && seconds <= 3600, "restart: ", seconds,
          " s to settle are not in 0 to 3600");
  validate(body.scenery);
  applyLevel(hair);
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
  ColliderFadeIn growing(body, hair.guides);
  hair.remember(frames > 0 ? growing.at(0) : body);
  if (frames == 0) redraw(hair);
  for (int i = 1; i <= frames; ++i)
    frame(growing.at(static_cast<float>(i) / static_cast<float>(frames)), still, 1.0f / 60, hair,
          unused);
  std::fill(hair.guides.velocity.begin(), hair.guides.velocity.end(), LaneVec3{});
  hair.time = 0;
}

}  // namespace hair

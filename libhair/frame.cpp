#include <libhair/frame.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/shadow/deposit.h>
#include <libhair/shadow/filter.h>
#include <libhair/shadow/occlude.h>
#include <libhair/shadow/transmittance.h>

namespace hair {

namespace {

ColliderState collidersOf(const BodyState& body, const MeshSdf* head) {
  return {body.worldFromHead, body.worldFromHead, body.capsules, body.capsules, head, body.scenery};
}

Scenery sceneryBefore(const Hair& hair, const Scenery& now) {
  Scenery before;
  if (hair.planes.size() == now.planes.size()) before.planes = hair.planes;
  if (hair.meshes.size() == now.meshes.size()) before.meshes = hair.meshes;
  return before;
}

void keepScenery(const Scenery& scenery, Hair& hair) {
  hair.planes.assign(scenery.planes.begin(), scenery.planes.end());
  hair.meshes.assign(scenery.meshes.begin(), scenery.meshes.end());
}

// Scenery that comes to hair at rest.
struct GrowingScenery {
  std::vector<Plane> planes;
  std::vector<MeshCollider> meshes;
  Scenery full;
  std::vector<float> below;  // metres from each plane down to the lowest guide point

  GrowingScenery(const Scenery& scenery, const GuideStrands& guides)
      : planes(scenery.planes.begin(), scenery.planes.end()),
        meshes(scenery.meshes.begin(), scenery.meshes.end()),
        full(scenery) {
    for (const Plane& plane : planes) {
      float lowest = 0;
      for (std::size_t g = 0; g < guides.guideCount(); ++g)
        for (std::uint32_t i = 0; i < guides.pointsPerGuide(); ++i)
          lowest = std::min(lowest, distanceAndGradient(plane, guides.point(g, i)).w);
      below.push_back(-lowest);
    }
  }
  Scenery at(float share) {
    for (std::size_t p = 0; p < planes.size(); ++p)
      planes[p].point = full.planes[p].point - (1 - share) * below[p] * planes[p].normal;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      // About its middle; a mesh of no size is none.
      const MeshCollider& whole = full.meshes[m];
      const glm::vec3 middle = whole.scale * whole.sdf->box().centre();
      const float size = std::max(share, 0.01f);
      meshes[m].scale = size * whole.scale;
      meshes[m].worldFromMesh.translation = whole.worldFromMesh.point((1 - size) * middle);
    }
    return {planes, meshes};
  }
};

}  // namespace

Hair::Hair(const Groom& groom_, const FrameSettings& settings, const BodyState& body,
           const MeshSdf* head_, const WispSettings& wispSettings)
    : groom(&groom_),
      head(head_),
      guides(groom_, settings.guides, body.worldFromHead, head_),
      wisps(groom_, guides, wispSettings, head_),
      worldFromHead(body.worldFromHead),
      capsules(body.capsules.begin(), body.capsules.end()) {
  validate(body.scenery);
  keepScenery(body.scenery, *this);
  if (settings.selfCollision)
    allowRestDensity(strands(), groom->fibre, guides, settings.repulsion, repulsion);
}

void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile) {
  const auto guidePoints =
      static_cast<std::int64_t>(hair.guides.guideCount() * hair.guides.pointsPerGuide());
  const auto points = static_cast<std::int64_t>(hair.wisps.points.size());
  {
    const StageTimer timer(profile, Stage::Guides, guidePoints);
    const std::span<const LaneVec3> push =
        settings.selfCollision ? hair.repulsion.push : std::span<const LaneVec3>{};
    const bool sheltered = settings.selfCollision && settings.wind.shelter > 0 &&
                           hair.repulsion.windShare.size() == hair.guides.position.size();
    stepGuides({body.worldFromHead, body.capsules, hair.capsules, hair.head, settings.wind,
                hair.time, push, sheltered ? hair.repulsion.windShare : std::span<const Lanes>{},
                body.scenery, sceneryBefore(hair, body.scenery)},
               settings.guides, seconds, hair.workspace, hair.guides);
  }
  {
    const StageTimer timer(profile, Stage::Wisps, points);
    interpolateWisps(hair.guides, collidersOf(body, hair.head), hair.wisps);
  }
  if (settings.selfCollision) {
    const StageTimer timer(profile, Stage::SelfCollision, guidePoints);
    measureDensity(hair.strands(), hair.groom->fibre, settings.repulsion, hair.repulsion.density);
    repel(hair.guides, settings.repulsion, hair.repulsion);
    if (settings.wind.shelter > 0) shelter(hair.guides, settings.wind, hair.repulsion);
  }
  hair.worldFromHead = body.worldFromHead;
  hair.capsules.assign(body.capsules.begin(), body.capsules.end());
  keepScenery(body.scenery, hair);
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
      clear(map, settings.map, lightSpaceOf(settings.lights[l], hair.pivot()));
      deposit(hair.strands(), hair.groom->fibre, map);
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
  hair.time = 0;
  std::fill(hair.repulsion.push.begin(), hair.repulsion.push.end(), LaneVec3{});
  std::vector<Capsule> grown(body.capsules.begin(), body.capsules.end());
  const int frames = static_cast<int>(std::ceil(seconds * 60));
  const auto sizeTo = [&](int i) {
    const float share = static_cast<float>(i) / static_cast<float>(frames);
    for (std::size_t c = 0; c < grown.size(); ++c)
      grown[c].radius = share * body.capsules[c].radius;
  };
  GrowingScenery scenery(body.scenery, hair.guides);
  if (frames > 0) sizeTo(0);
  hair.capsules = grown;
  keepScenery(frames > 0 ? scenery.at(0) : body.scenery, hair);
  hair.worldFromHead = body.worldFromHead;
  if (frames == 0) interpolateWisps(hair.guides, collidersOf(body, hair.head), hair.wisps);
  for (int i = 1; i <= frames; ++i) {
    sizeTo(i);
    const Scenery risen = scenery.at(static_cast<float>(i) / static_cast<float>(frames));
    frame({body.worldFromHead, grown, risen}, still, 1.0f / 60, hair, unused);
  }
  std::fill(hair.guides.velocity.begin(), hair.guides.velocity.end(), LaneVec3{});
  hair.time = 0;
}

}  // namespace hair

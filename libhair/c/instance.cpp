#include <libhair/c/instance.h>

#include <libhair/c/boundary.h>
#include <libhair/guides/validate.h>
#include <libhair/simulation/scene_changes.h>

namespace hair::c {

namespace {

FrameSettings checkedSettings(const hair_settings* settings, const FrameSettings& base) {
  const FrameSettings taken = frameSettings(settings, base);
  tryOut(taken);
  return taken;
}

// Null: as it was.
const OwnBody& takeBody(const hair_body* body, OwnBody& own) {
  if (body) take(taken(body, hair_body{}, "hair_body"), own);
  return own;
}

}  // namespace

void requireFrame(const BodyState& body, const std::vector<Light>& lights,
                  const GuideStrands& guides) {
  validate(body.worldFromHead);
  validate(body.capsules);
  validate(body.scenery);
  requirePrecision(guides, body.worldFromHead);
  for (const Light& light : lights) lightSpaceOf(light, body.worldFromHead.translation);
}

void tryOut(const FrameSettings& settings) {
  // A frame of one strand meets every check that a frame of many meets.
  const std::vector<glm::vec3> strand = {{0, 0.1f, 0}, {0, 0.07f, 0}, {0, 0.04f, 0}, {0, 0.01f, 0}};
  const Groom groom = groomOfGuides(strand, 4);
  Hair hair(groom, settings, {});
  FrameProfile unused{};
  frame({}, settings, 1.0f / 60, hair, unused);
}

Groom groomOfGuides(std::span<const glm::vec3> points, std::uint32_t pointsPerGuide) {
  Groom groom;
  groom.pointsPerGuide = pointsPerGuide;
  groom.guidePoints.assign(points.begin(), points.end());
  for (std::uint32_t g = 0; g < groom.guideCount(); ++g) {
    groom.first.push_back((g + 1) * pointsPerGuide);
    groom.parents.emplace_back(g);
    groom.weights.emplace_back(1, 0, 0);
  }
  return groom;
}

}  // namespace hair::c

using namespace hair::c;
using hair::require;

hair_instance::hair_instance(hair::Groom groom_, std::shared_ptr<const hair::MeshSdf> head_,
                             const hair_settings* settings_, const hair_body* body_)
    : groom(std::move(groom_)),
      head(std::move(head_)),
      settings(checkedSettings(settings_, {})),
      hair(groom, settings, takeBody(body_, body).state(), head.get()) {
  requireFrame(body.state(), settings.lights, hair.guides);
  light(settings, hair, profile);
}

hair_status hair_set_settings(hair_instance* hair, const hair_settings* settings) {
  return computed([&] {
    given(hair, "hair_instance");
    given(settings, "hair_settings");
    hair->settings = checkedSettings(settings, hair->settings);
  });
}

hair_status hair_set_lights(hair_instance* hair, const hair_light* lights, uint32_t count) {
  return guarded([&] {
    given(hair, "hair_instance");
    require(lights || count == 0, "hair_set_lights: lights is null");
    require(count <= 256, "hair_set_lights: ", count, " lights are more than 256");
    std::vector<hair::Light> taken;
    for (uint32_t l = 0; l < count; ++l) {
      taken.push_back(lightOf(lights[l]));
      lightSpaceOf(taken.back(), hair->hair.pivot());
    }
    hair->settings.lights = std::move(taken);
  });
}

hair_status hair_step(hair_instance* hair, const hair_body* body, float seconds) {
  return computed([&] {
    given(hair, "hair_instance");
    require(seconds >= 1e-6f && seconds <= 1, "hair_step: ", seconds, " s are not in 1e-6 to 1");
    OwnBody next = hair->body;
    const hair::BodyState state = takeBody(body, next).state();
    requireFrame(state, hair->settings.lights, hair->hair.guides);
    frame(state, hair->settings, seconds, hair->hair, hair->profile);
    hair->body = std::move(next);
  });
}

hair_status hair_relight(hair_instance* hair) {
  return computed([&] {
    hair::Hair& h = given(hair, "hair_instance").hair;
    if (h.level != h.wisps.drawn.level) redraw(h);
    light(hair->settings, h, hair->profile);
  });
}

hair_status hair_head_pixels(float distance, float field_of_view, float picture_height,
                             float* pixels) {
  return guarded([&] {
    given(pixels, "pixels");
    *pixels = hair::headPixels(distance, field_of_view, picture_height);
  });
}

hair_status hair_set_detail(hair_instance* hair, float pixels, float importance) {
  return computed([&] {
    given(hair, "hair_instance");
    if (!hair->detail) hair->detail.emplace(hair->groom);
    hair->hair.detail = &*hair->detail;
    hair->hair.level =
        pixels == 0 ? hair::LevelOfDetail{} : levelFor(*hair->detail, pixels, importance);
  });
}

hair_status hair_restart(hair_instance* hair, const hair_body* body, float settle) {
  return computed([&] {
    given(hair, "hair_instance");
    require(settle >= 0 && settle <= 3600, "hair_restart: ", settle, " s are not in 0 to 3600");
    OwnBody next = hair->body;
    const hair::BodyState state = takeBody(body, next).state();
    requireFrame(state, hair->settings.lights, hair->hair.guides);
    restart(state, hair->settings, settle, hair->hair);
    light(hair->settings, hair->hair, hair->profile);
    hair->body = std::move(next);
  });
}

hair_status hair_teleport(hair_instance* hair, const hair_transform* world_from_head) {
  return computed([&] {
    given(hair, "hair_instance");
    const auto there = transformOf(given(world_from_head, "hair_transform"));
    requireFrame({there, {}}, hair->settings.lights, hair->hair.guides);
    teleport(there, hair->hair);
    light(hair->settings, hair->hair, hair->profile);
    hair->body.worldFromHead = there;
    hair->body.capsules = hair->hair.capsules;
    hair->body.planes = hair->hair.planes;
  });
}

#include <libhair/c/instance.h>

#include <libhair/c/boundary.h>

namespace hair::c {

namespace {

// The caller's body; null: `before`. `own` holds its arrays.
BodyState stateOf(const hair_body* body, const BodyState& before, OwnBody& own) {
  if (!body) return before;
  take(taken(body, hair_body{}, "hair_body"), own);
  return own.state();
}

}  // namespace

std::unique_ptr<hair_instance> makeInstance(std::shared_ptr<const Groom> groom,
                                            std::shared_ptr<const MeshSdf> head,
                                            const hair_settings* settings, const hair_body* body) {
  OwnBody own;
  return std::make_unique<hair_instance>(std::move(groom), frameSettings(settings),
                                         stateOf(body, {}, own), std::move(head));
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

hair_status hair_set_settings(hair_instance* hair, const hair_settings* settings) {
  return computed([&] {
    given(hair, "hair_instance");
    given(settings, "hair_settings");
    hair->simulation.setSettings(frameSettings(settings, hair->simulation.settings()));
  });
}

hair_status hair_set_lights(hair_instance* hair, const hair_light* lights, uint32_t count) {
  return guarded([&] {
    given(hair, "hair_instance");
    require(lights || count == 0, "hair_set_lights: lights is null");
    require(count <= 256, "hair_set_lights: ", count, " lights are more than 256");
    hair::FrameSettings settings = hair->simulation.settings();
    settings.lights.clear();
    for (uint32_t l = 0; l < count; ++l) settings.lights.push_back(lightOf(lights[l]));
    hair->simulation.setSettings(settings);
  });
}

hair_status hair_step(hair_instance* hair, const hair_body* body, float seconds) {
  return computed([&] {
    hair::Simulation& simulation = given(hair, "hair_instance").simulation;
    simulation.step(stateOf(body, simulation.body(), hair->body), seconds);
  });
}

hair_status hair_relight(hair_instance* hair) {
  return computed([&] { given(hair, "hair_instance").simulation.relight(); });
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
    hair::Simulation& simulation = given(hair, "hair_instance").simulation;
    simulation.setLevel(pixels == 0 ? hair::LevelOfDetail{}
                                    : levelFor(*simulation.detail(), pixels, importance));
  });
}

hair_status hair_restart(hair_instance* hair, const hair_body* body, float settle) {
  return computed([&] {
    hair::Simulation& simulation = given(hair, "hair_instance").simulation;
    simulation.restart(stateOf(body, simulation.body(), hair->body), settle);
  });
}

hair_status hair_teleport(hair_instance* hair, const hair_transform* world_from_head) {
  return computed([&] {
    hair::Simulation& simulation = given(hair, "hair_instance").simulation;
    simulation.teleport(transformOf(given(world_from_head, "hair_transform")));
  });
}

#include "small_hair.h"

#include <sstream>

#include <libhair/core/state_hash.h>
#include <libhair/simulation/frame.h>

namespace hair {

namespace {

FrameSettings settingsOf(bool full) {
  FrameSettings settings;
  settings.shadow = settings.shade = false;
  settings.selfCollision = full;
  settings.repulsion.threshold = 0;
  settings.repulsion.tolerance = 1;
  if (full) settings.wind.velocity = {3, 0, 1}, settings.wind.occlusion = 1e-4f;
  return settings;
}

Groom threeStrands() {
  Groom groom;
  groom.pointsPerGuide = 3;
  for (const float x : {0.0f, 0.03f})
    for (const float y : {0.0f, -0.02f, -0.04f}) groom.guidePoints.emplace_back(x, y, 0.1f);
  groom.first = {0, 2, 4, 7};
  groom.parents = {{0, 1, 1}, {1, 0, 0}, {0, 1, 1}};
  groom.weights = {{1, 0, 0}, {1, 0, 0}, {0.5f, 0.25f, 0.25f}};
  return groom;
}

TriangleMesh cube() {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.push_back(0.02f * glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace

SmallHair::SmallHair(bool full)
    : settings(settingsOf(full)),
      groom(threeStrands()),
      block(cube(), 0.005f, 0.01f),
      planes(full ? 1 : 0, Plane{{0, -0.045f, 0}}),
      meshes(full ? 1 : 0, MeshCollider{&block, {{1, 0, 0, 0}, {-0.03f, -0.04f, 0.1f}}}),
      capsules(full ? 1 : 0, Capsule{{0.01f, -0.03f, 0.08f}, {0.02f, -0.03f, 0.08f}, 0.01f}),
      hair(groom, settings, {{}, capsules, {planes, meshes}}) {}

void SmallHair::step() {
  const float t = static_cast<float>(++frames % 60) / 60;
  frame({{glm::angleAxis(3 * t, glm::vec3(0, 1, 0)), {0, 0, t}}, capsules, {planes, meshes}},
        settings, 1.0f / 60, hair, profile);
}

std::string SmallHair::state() const {
  std::ostringstream out;
  saveState(hair, out);
  return out.str();
}

std::string withCheckSum(std::string state) {
  constexpr std::size_t kSum = sizeof(std::uint64_t);
  if (state.size() < kSum) return state;
  StateHash hash;
  hash.add(std::span<const char>(state).first(state.size() - kSum));
  const std::uint64_t sum = hash.value();
  state.replace(state.size() - kSum, kSum, reinterpret_cast<const char*>(&sum), kSum);
  return state;
}

std::vector<std::string> sampleStates() {
  std::vector<std::string> states;
  for (const bool full : {true, false}) {
    SmallHair small(full);
    states.push_back(small.state());
    for (int f = 0; f < 4; ++f) small.step();
    states.push_back(small.state());
  }
  return states;
}

}  // namespace hair

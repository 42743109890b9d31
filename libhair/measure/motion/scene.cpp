#include <libhair/measure/motion/scene.h>

#include <libhair/core/error.h>

namespace hair {

namespace {

BodyPose firstPose(const MeasuredScene& scene) {
  require(scene.groom != nullptr, "measured scene: no groom");
  require(scene.pose != nullptr, "measured scene: no pose; give Motion::pose of a motion");
  BodyPose pose;
  scene.pose(0, pose);
  return pose;
}

BodyState stateOf(const MeasuredScene& scene, const BodyPose& pose) {
  return {pose.worldFromHead,
          scene.bodyContact ? std::span<const Capsule>(pose.capsules) : std::span<const Capsule>{}};
}

}  // namespace

ScenePlayer::ScenePlayer(const MeasuredScene& scene_)
    : scene(scene_),
      pose(firstPose(scene_)),
      simulation(scene.groom, scene.settings, stateOf(scene, pose),
                 scene.head ? borrowed(*scene.head) : nullptr, scene.wisps),
      hair(simulation.hair()) {
  simulation.restart(body(), scene.settle);
}

BodyState ScenePlayer::body() const {
  return stateOf(scene, pose);
}

void ScenePlayer::step() {
  ++frames;
  scene.pose(static_cast<double>(frames) * scene.frameSeconds, pose);
  simulation.setSettings(scene.settings);
  profile = simulation.step(body(), scene.frameSeconds);
}

}  // namespace hair

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
      hair(*scene.groom, scene.settings, stateOf(scene, pose), scene.head, scene.wisps) {
  restart(body(), scene.settings, scene.settle, hair);
}

BodyState ScenePlayer::body() const {
  return stateOf(scene, pose);
}

void ScenePlayer::step() {
  profile = {};
  ++frames;
  scene.pose(static_cast<double>(frames) * scene.frameSeconds, pose);
  frame(body(), scene.settings, scene.frameSeconds, hair, profile);
}

}  // namespace hair

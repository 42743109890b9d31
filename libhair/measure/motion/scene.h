#pragma once

#include <functional>
#include <memory>

#include <libhair/core/api.h>
#include <libhair/motion/motion.h>
#include <libhair/simulation/simulation.h>

namespace HAIR_API hair {

/// Input of a measurement, run repeatedly: hair on a moving body. Change fields of a copy to leave
/// something out.
struct MeasuredScene {
  std::shared_ptr<const Groom> groom;  ///< shared by all copies
  const MeshSdf* head = nullptr;  ///< collider in head space, null: none; must outlive the scene
  FrameSettings settings;         ///< what a frame computes
  WispSettings wisps;             ///< how drawn strands keep out of colliders
  bool bodyContact = true;        ///< false: without the body's capsules
  /// Where head and body are `seconds` after the start: Motion::pose.
  std::function<void(double seconds, BodyPose& out)> pose;
  float frameSeconds = 1.0f / 60;  ///< of the picture, (0, 1]
  float settle = 1;                ///< seconds in the first pose before the first frame, >= 0
};

/// A running scene: its hair and the pose of its body.
struct ScenePlayer {
  /// Settled in the first pose. Throws Error: no groom, no pose, and as Simulation does.
  explicit ScenePlayer(const MeasuredScene& scene);

  /// Advances by one frame.
  void step();
  /// Pose of the body; valid until the next step.
  BodyState body() const;

  MeasuredScene scene;      ///< a copy of what was asked for
  BodyPose pose;            ///< at the last frame's end
  Simulation simulation;    ///< takes over the scene's settings with every frame
  Hair& hair;               ///< the simulation's, as the last frame left it
  FrameProfile profile{};   ///< of the last frame
  std::int64_t frames = 0;  ///< so far
};

}  // namespace hair

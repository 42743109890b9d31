#include <apps/common/measured.h>

#include <libhair/core/error.h>

namespace hair {

MeasuredScene measuredScene(const Character& character, const PlayerOptions& options, int frames) {
  MeasuredScene scene;
  scene.groom = borrowed(character.groom);
  scene.head = character.headCollider.get();
  scene.settings = frameSettings(character, options);
  scene.pose = [&motion = character.motion](double t, BodyPose& out) { motion.pose(t, out); };
  scene.frameSeconds = static_cast<float>(1 / options.fps);
  scene.settle = options.settle;
  const double duration = character.motion.duration();
  require(character.motion.isLoop() || duration == 0 || frames / options.fps <= duration + 1e-6,
          "the motion ends after ", duration, " s: --frames is at most ",
          static_cast<int>(duration * options.fps), " at --fps ", options.fps);
  return scene;
}

}  // namespace hair

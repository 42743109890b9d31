#include <apps/common/measured.h>

#include <libhair/core/error.h>

namespace hair {

MeasuredScene measuredScene(const Subject& subject, const PerformanceOptions& options, int frames) {
  MeasuredScene scene;
  scene.groom = borrowed(subject.groom);
  scene.head = subject.headCollider.get();
  scene.settings = frameSettings(subject, options);
  scene.pose = [&motion = subject.motion](double t, BodyPose& out) { motion.pose(t, out); };
  scene.frameSeconds = static_cast<float>(1 / options.fps);
  scene.settle = options.settle;
  const double duration = subject.motion.duration();
  require(subject.motion.isLoop() || duration == 0 || frames / options.fps <= duration + 1e-6,
          "the motion ends after ", duration, " s: --frames is at most ",
          static_cast<int>(duration * options.fps), " at --fps ", options.fps);
  return scene;
}

}  // namespace hair

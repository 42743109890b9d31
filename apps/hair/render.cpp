#include <iostream>

#include <apps/common/picture.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/image.h>
#include <apps/hair/commands.h>
#include <libhair/core/parallel.h>

namespace hair {

void runRender(const RenderOptions& options) {
  const ThreadLimit limit(options.threads);
  SubjectOptions still = options.subject;
  still.still = still.motion.empty();
  const Subject subject(still);
  for (const std::string& note : subject.notes) std::cerr << note << '\n';
  Performance performance(subject, options.performance);
  for (int f = 0; f < options.frames; ++f) performance.step();
  draw::OffscreenContext context;
  draw::Renderer renderer;
  Stagecraft stage(performance);
  stage.frameHead(options.yaw, options.pitch, options.distance);
  stage.sideBySide = options.sideBySide;
  renderer.draw(stage.scene(), options.width, options.height);
  draw::writeImage(renderer.read(), options.out);
}

}  // namespace hair

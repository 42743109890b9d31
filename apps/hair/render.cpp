#include <iostream>

#include <apps/common/progress.h>
#include <apps/common/staging.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/image.h>
#include <apps/hair/commands.h>
#include <libhair/core/parallel.h>

namespace hair {

void runRender(const RenderOptions& options) {
  const ThreadLimit limit(options.threads);
  SubjectOptions posed = options.subject;
  // A picture without motion is of the groom as it is.
  posed.still = posed.still || posed.motion.empty();
  const Subject subject(posed);
  for (const std::string& note : subject.notes) std::cerr << note << '\n';
  Performance performance(subject, options.performance);
  Progress progress("simulate", options.frames);
  for (int f = 0; f < options.frames; ++f) {
    performance.step();
    progress.step();
  }
  progress.finish();
  const draw::OffscreenContext context;
  draw::RenderSettings how;
  how.linear = draw::isLinear(options.out);
  draw::Renderer renderer(how);
  Staging staging(performance);
  staging.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
  staging.scene.sideBySide = options.sideBySide;
  staging.shown = options.shown;
  // Through hair everything is seen; a surface hides what is behind it.
  staging.scene.debug.onTop = !options.shown.meshSurface;
  renderer.draw(staging.update(renderer), options.width, options.height);
  if (how.linear)
    draw::writeImage(renderer.readLinear(), options.out);
  else
    draw::writeImage(renderer.read(), options.out);
}

}  // namespace hair

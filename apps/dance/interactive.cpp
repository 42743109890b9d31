#include <apps/dance/dance.h>
#include <apps/draw/window.h>

namespace hair {

int runInteractive(const DanceOptions& options) {
  draw::Window window("dance", options.width, options.height);
  draw::Renderer renderer({1, 2048, 60000});
  const Subject subject(options.subject);
  Performance performance(subject, options.performance);
  Staging staging(performance);
  staging.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
  while (window.beginFrame(staging.scene.camera, staging.scene.light)) {
    performance.step();
    renderer.draw(staging.update(renderer), window.width(), window.height());
    window.endFrame(renderer);
  }
  return 0;
}

}  // namespace hair

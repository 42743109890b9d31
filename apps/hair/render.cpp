#include <iostream>

#include <apps/common/progress.h>
#include <apps/common/scene_view.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/image.h>
#include <apps/hair/commands.h>
#include <libhair/core/parallel.h>

namespace hair {

void runRender(const RenderOptions& options) {
  const ThreadLimit limit(options.threads);
  CharacterOptions posed = options.character;
  // A picture without motion is of the groom as it is.
  posed.still = posed.still || posed.motion.empty();
  const Character character(posed);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  Player player(character, options.player);
  Progress progress("simulate", options.frames);
  for (int f = 0; f < options.frames; ++f) {
    player.step();
    progress.step();
  }
  progress.finish();
  const draw::OffscreenContext context;
  draw::RenderSettings how;
  how.linear = draw::isLinear(options.out);
  draw::Renderer renderer(how);
  SceneView view(player);
  view.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
  view.scene.sideBySide = options.sideBySide;
  view.shown = options.shown;
  // Through hair everything is seen; a surface hides what is behind it.
  view.scene.debug.onTop = !options.shown.meshSurface;
  renderer.draw(view.update(renderer), options.width, options.height);
  if (how.linear)
    draw::writeImage(renderer.readLinear(), options.out);
  else
    draw::writeImage(renderer.read(), options.out);
}

}  // namespace hair

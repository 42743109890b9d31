#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <apps/common/progress.h>
#include <apps/common/results.h>
#include <apps/dance/dance.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/image.h>
#include <apps/draw/video.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr int kSheetColumns = 4, kSheetRows = 4;

}  // namespace

std::string drawnBy() {
  const std::string name = draw::rendererName();
  return draw::drawsOnCpu(name) ? "the CPU (" + name + ")" : name;
}

int runHeadless(const DanceOptions& options) {
  const draw::OffscreenContext context;
  draw::Renderer renderer;
  const Character character(options.character);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  Player player(character, options.player);
  SceneView view(player);
  view.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
  view.scene.sideBySide = options.sideBySide;

  const double fps = options.player.fps;
  const double seconds = character.motion.duration() > 0
                             ? character.motion.duration() / options.player.motionSpeed
                             : 5;
  const int frames = options.frames > 0
                         ? options.frames
                         : std::max(1, static_cast<int>(std::floor(seconds * fps + 1e-6)));
  // Every so many simulated frames there is a picture.
  const int stride = std::max(1, static_cast<int>(std::lround(fps / options.videoFps)));
  const int pictures = (frames + stride - 1) / stride;
  const int tiles = kSheetColumns * kSheetRows;

  draw::VideoWriter video(options.out, options.width, options.height, fps / stride);
  std::vector<draw::Picture> sheet;
  draw::Picture picture;
  StatsLog stats;
  ProfileLog drawn;  // of the frames that there is a picture of
  Progress progress("dance", frames);
  for (int f = 0; f < frames; ++f) {
    player.step();
    if (!options.results.stats.empty()) stats.add(player);
    if (f % stride == 0) {
      view.drawTimed(renderer, options.width, options.height);
      drawn.add(player.profile);
      renderer.read(picture);
      video.add(picture);
      // Tile t of the sheet is the picture nearest to t / tiles of the whole.
      const auto tile = static_cast<int>(sheet.size());
      if (tile < tiles && f / stride >= tile * pictures / tiles)
        sheet.push_back(draw::downscaled(picture, options.width / 2, options.height / 2));
    }
    progress.step();
  }
  progress.finish();
  video.finish();
  std::filesystem::path sheetFile = options.out;
  sheetFile.replace_extension(".png");
  draw::writeImage(
      draw::contactSheet(sheet, std::min<int>(kSheetColumns, static_cast<int>(sheet.size()))),
      sheetFile);
  std::cout << options.out.string() << " and " << sheetFile.string() << ": " << pictures
            << " pictures of " << frames << " frames\n"
            << drawingTimes(drawn, drawnBy()) << '\n';
  writeResults(options.results, player, drawn, stats);
  return 0;
}

}  // namespace hair

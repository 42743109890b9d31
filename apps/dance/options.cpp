#include <apps/dance/options.h>

#include <apps/common/command_line.h>

namespace hair {

void addDanceOptions(CLI::App& app, DanceOptions& options) {
  addCharacterOptions(app, options.character);
  addPlayerOptions(app, options.player, options.threads);
  addResultOptions(app, options.results);
  app.add_flag("--headless", options.headless, "no window, even where there is a display");
  app.add_option("--frames", options.frames,
                 "frames to simulate, then stop; default: the whole motion, or until the window is "
                 "closed")
      ->check(CLI::Range(1, 10'000'000));
  app.add_option("--out", options.out,
                 "headless: the video; default dance.mp4, with dance.png beside it")
      ->check(endsWith(".mp4"));
  app.add_option("--video-fps", options.videoFps, "headless: pictures a second; default 30")
      ->check(within(1.0, 240.0));
  app.add_option("--width", options.width, "pixels; default 1280")->check(CLI::Range(16, 8192));
  app.add_option("--height", options.height, "pixels; default 720")->check(CLI::Range(16, 8192));
  app.add_option("--yaw", options.yaw, "degrees about the head, 0: before the face; default 35")
      ->check(within(-360, 360));
  app.add_option("--pitch", options.pitch, "degrees from above; default 4")
      ->check(within(-89.0, 89.0));
  app.add_option("--distance", options.distance, "of the camera, metres; default 1.5")
      ->check(within(0.05, 100.0));
  app.add_flag("--side-by-side", options.sideBySide, "left half without self-shadowing");
  app.footer(
      "Examples:\n"
      "  dance\n"
      "  dance --style curly --motion dance.bvh --headless --out curly.mp4\n"
      "  dance --hair sintel.tfx --head sintel.obj --side-by-side\n"
      "In the window: left drag orbits, right drag moves the first light, wheel zooms; space "
      "pauses,\n"
      "S steps, R resets, Tab hides the panel.\n"
      "Exit codes: 0 done, 1 bad input, 2 bad usage.");
}

}  // namespace hair

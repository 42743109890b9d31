// The program `dance`: motion capture, or a dance of our own, drives hair through every stage.
// Exit codes: 0 done, 1 bad input or a failure (one line on the error stream), 2 bad usage.
#include <apps/common/command_line.h>
#include <apps/dance/dance.h>
#include <apps/draw/window.h>
#include <libhair/core/parallel.h>

namespace hair {
namespace {

int program(int argc, char** argv) {
  CLI::App app(
      "Hair that dances. With a display it opens a window; without one it writes a video "
      "and a contact sheet.",
      "dance");
  DanceOptions options;
  addSubjectOptions(app, options.subject);
  addPerformanceOptions(app, options.performance, options.threads);
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  const ThreadLimit limit(options.threads);
  return options.headless || !draw::windowAvailable() ? runHeadless(options)
                                                      : runInteractive(options);
}

}  // namespace
}  // namespace hair

int main(int argc, char** argv) {
  return hair::runReporting("dance", [&] { return hair::program(argc, argv); });
}

// The program `dance`: motion capture, or a dance of our own, drives hair through every stage.
// Exit codes: 0 done, 1 bad input or a failure (one line on the error stream), 2 bad usage.
#include <apps/common/command_line.h>
#include <apps/dance/options.h>
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
  addDanceOptions(app, options);
  if (const std::optional<int> code = exitCodeOfParsing(app, argc, argv)) return *code;
  const ThreadLimit limit(options.threads);
  return options.headless || !draw::windowAvailable() ? runHeadless(options)
                                                      : runInteractive(options);
}

}  // namespace
}  // namespace hair

int main(int argc, char** argv) {
  return hair::runReporting("dance", [&] { return hair::program(argc, argv); });
}

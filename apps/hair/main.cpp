// The program `hair`: reads the command line; commands.h says what each command does.
// Exit codes: 0 done, 1 bad input or a failure (one line on the error stream), 2 bad usage.
#include <iostream>

#include <apps/common/command_line.h>
#include <apps/hair/options.h>
#include <libhair/core/error.h>

namespace hair {
namespace {

// As it would be typed again.
std::string commandLineOf(int argc, char** argv) {
  std::string line = "hair";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789-_=+.,:/%@") == std::string::npos;
    line += ' ';
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

int program(int argc, char** argv) {
  CLI::App app("Hair: files, simulation, pictures. `hair COMMAND --help` explains each command.",
               "hair");
  app.set_version_flag("--version", "hair " HAIR_VERSION);
  Run run;
  addCommands(app, run, commandLineOf(argc, argv));
  if (const std::optional<int> code = exitCodeOfParsing(app, argc, argv)) return *code;
  run();
  require(std::cout.flush().good(), "cannot write to the standard output");
  return 0;
}

}  // namespace
}  // namespace hair

int main(int argc, char** argv) {
  return hair::runReporting("hair", [&] { return hair::program(argc, argv); });
}

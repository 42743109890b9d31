// The program `hair`: reads the command line; commands.h says what each command does.
// Exit codes: 0 done, 1 bad input or a failure (one line on the error stream), 2 bad usage.
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include <apps/hair/commands.h>
#include <libhair/core/error.h>

namespace hair {
namespace {

// What the chosen command will do once the whole command line has been understood.
using Run = std::function<void()>;

void addReadOptions(CLI::App& command, ReadOptions& read) {
  command
      .add_option("--scale", read.scale,
                  "metres per unit of the file; default: .hair 0.00465, others 1")
      ->check(CLI::PositiveNumber);
  command
      .add_option_function<std::string>(
          "--up",
          [&read](const std::string& text) {
            try {
              read.up = upAxisFromText(text);
            } catch (const Error& e) {
              throw CLI::ValidationError("--up", e.what());
            }
          },
          "axis of the file that points up: y (face +z), z (face +y), z-back (face -y: Blender), "
          "x, y-down; default: .hair z, others y")
      ->type_name("AXIS");
}

void addInfo(CLI::App& app, Run& run) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a file holds");
  command->add_option("FILE", options->file, ".hair, .tfx, .data, .obj or .bvh")->required();
  addReadOptions(*command, options->read);
  command->footer(
      "Examples:\n"
      "  hair info straight.hair\n"
      "  hair info exported.hair --scale 0.01 --up z-back   # centimetres, from Blender\n"
      "A head is about 0.2 m high: if the bounds say otherwise, give --scale.");
  command->callback([options, &run] { run = [options] { runInfo(*options); }; });
}

void addConvert(CLI::App& app, Run& run) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert", "Write strands of any format as .hair in metres, +Y up");
  command->add_option("IN", options->in, ".hair, .tfx or .data")->required();
  command->add_option("OUT", options->out, "file to write, .hair")
      ->required()
      ->check([](const std::string& out) {
        return out.ends_with(".hair") ? std::string() : "must end with .hair: " + out;
      });
  addReadOptions(*command, options->read);
  command
      ->add_option("--strands", options->strands,
                   "keep so many strands, a random choice that is always the same")
      ->check(CLI::Range(1, 2'000'000'000));
  command
      ->add_option("--points", options->points,
                   "points of every strand, evenly along its length; default: as they are")
      ->check(CLI::Range(2, 65536));
  command
      ->add_option("--min-length", options->minLength,
                   "drop strands that are shorter, metres; default 0.001")
      ->check(CLI::NonNegativeNumber);
  command->footer(
      "Examples:\n"
      "  hair convert sintel.tfx sintel.hair\n"
      "  hair convert strands.data light.hair --strands 2000 --points 32\n"
      "Colours, thickness and transparency of .hair files come along.");
  command->callback([options, &run] { run = [options] { runConvert(*options); }; });
}

int program(int argc, char** argv) {
  CLI::App app("Hair: files, simulation, pictures. `hair COMMAND --help` teaches each command.",
               "hair");
  app.set_version_flag("--version", "hair " HAIR_VERSION);
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 bad input, 2 bad usage.");
  Run run;
  addInfo(app, run);
  addConvert(app, run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  run();
  require(std::cout.flush().good(), "cannot write to the standard output");
  return 0;
}

}  // namespace
}  // namespace hair

int main(int argc, char** argv) {
  try {
    return hair::program(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "hair: out of memory\n";
  } catch (const std::exception& e) {
    std::cerr << "hair: " << e.what() << '\n';
  }
  return 1;
}

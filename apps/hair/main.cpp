// The program `hair`: reads the command line; commands.h says what each command does.
// Exit codes: 0 done, 1 bad input or a failure (one line on the error stream), 2 bad usage.
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include <apps/common/command_line.h>
#include <apps/hair/commands.h>
#include <libhair/core/error.h>

namespace hair {
namespace {

// What the chosen command will do once the whole command line has been understood.
using Run = std::function<void()>;

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
      ->check(endsWith(".hair"));
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

void addSimulate(CLI::App& app, Run& run) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Simulate hair; write strands, times, statistics or a hash");
  addSubjectOptions(*command, options->subject);
  addPerformanceOptions(*command, options->performance, options->threads);
  command->add_option("--frames", options->frames, "frames to simulate; default 120")
      ->check(CLI::Range(1, 10'000'000));
  command
      ->add_option("--out", options->out,
                   "strands of every frame: out.hair becomes out.0000.hair, out.0001.hair ...")
      ->check(endsWith(".hair"));
  addResultOptions(*command, options->results);
  command->footer(
      "Examples:\n"
      "  hair simulate --style smooth --frames 600 --hash\n"
      "  hair simulate --hair sintel.tfx --head sintel.obj --motion dance.bvh --out sintel.hair\n"
      "  hair simulate --style curly --profile times.csv --stats stats.csv");
  command->callback([options, &run] { run = [options] { runSimulate(*options); }; });
}

void addRender(CLI::App& app, Run& run) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw one picture of hair under any light");
  addSubjectOptions(*command, options->subject);
  addPerformanceOptions(*command, options->performance, options->threads);
  command->add_option("--out", options->out, "the picture, .png or .exr")
      ->required()
      ->check([](const std::string& name) {
        return name.ends_with(".exr") ? endsWith(".exr")(name) : endsWith(".png")(name);
      });
  command
      ->add_option("--frames", options->frames,
                   "frames of the motion before the picture; default 0")
      ->check(CLI::Range(0, 10'000'000));
  command
      ->add_option("--yaw", options->yaw, "degrees about the head, 0: before the face; default 30")
      ->check(within(-360, 360));
  command->add_option("--pitch", options->pitch, "degrees from above; default 3")
      ->check(within(-89.0, 89.0));
  command->add_option("--distance", options->distance, "metres; default 0.95")
      ->check(within(0.05, 100.0));
  command->add_option("--width", options->width, "pixels; default 960")
      ->check(CLI::Range(16, 16384));
  command->add_option("--height", options->height, "pixels; default 960")
      ->check(CLI::Range(16, 16384));
  command->add_flag("--side-by-side", options->sideBySide, "left half without self-shadowing");
  command->add_flag("--show-guides", options->shown.guides, "draw the simulated strands");
  command->add_flag("--show-colliders", options->shown.colliders, "draw the body's capsules");
  command->add_flag("--show-cells", options->shown.cells,
                    "draw the occupied cells by transmittance");
  command->footer(
      "Examples:\n"
      "  hair render --style smooth --out smooth.png --side-by-side --width 1600 --height 800\n"
      "  hair render --hair sintel.tfx --head sintel.obj --light 0.5,-0.8,-0.35 --out sintel.png\n"
      "  hair render --style curly --motion dance.bvh --frames 300 --out frame300.exr");
  command->callback([options, &run] { run = [options] { runRender(*options); }; });
}

void addMeasureMotion(CLI::App& app, Run& run) {
  auto options = std::make_shared<MeasureMotionOptions>();
  CLI::App* command = app.add_subcommand(
      "measure-motion", "Error and time of the motion over substeps and numbers of guides");
  addSubjectOptions(*command, options->subject);
  addPerformanceOptions(*command, options->performance, options->threads);
  SimulationTrialSettings& trial = options->trial;
  command->add_option("--frames", trial.frames, "frames of every run; default 120")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--early", trial.earlyFrames,
                   "frames of the means over the first and the last; default 30")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--reference", trial.referenceSubsteps,
                   "substeps a frame of the converged run, even; default 64")
      ->check(CLI::Range(2, 1024));
  command->add_option("--substeps", trial.substeps, "a frame; default 1,2,4,8,16,32")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--iterations", trial.iterations,
                   "Newton iterations a substep, beside the usual 2; default 1,4")
      ->delimiter(',')
      ->check(CLI::Range(1, 32));
  command
      ->add_option("--guide-counts", options->guideCounts,
                   "guides that the drawn strands are bound to; default 402,201,100,50,25")
      ->delimiter(',')
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--csv", options->csv, "the same table, a row a setting")
      ->check(endsWith(".csv"));
  command->footer(
      "Examples:\n"
      "  hair measure-motion --style smooth --csv motion.csv\n"
      "  hair measure-motion --no-self-collision --substeps 4,8 --guide-counts 100\n"
      "`half of reference` is how far the converged run is from one with half its substeps, "
      "`twin`\n"
      "how far a run is from the same with points 0.01 mm/s faster at the start: contact is "
      "chaotic,\n"
      "and distances below the twin's mean nothing.");
  command->callback([options, &run] { run = [options] { runMeasureMotion(*options); }; });
}

void addPlan(CLI::App& app, Run& run) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command =
      app.add_subcommand("plan", "What each feature costs in this scene, and leaving it out saves");
  addSubjectOptions(*command, options->subject);
  addPerformanceOptions(*command, options->performance, options->threads);
  command->add_option("--frames", options->frames, "frames of every performance; default 120")
      ->check(CLI::Range(10, 1'000'000));
  command->add_option("--csv", options->csv, "the same table, a row a feature")
      ->check(endsWith(".csv"));
  command->footer(
      "Examples:\n"
      "  hair plan --style curly\n"
      "  hair plan --hair sintel.tfx --head sintel.obj --csv plan.csv\n"
      "own ms: in stages that run for the feature alone. saves ms: what a frame is faster without "
      "it,\n"
      "+- the standard error. moves, recolours: what leaving it out changes of points (mm) and "
      "colours\n"
      "(of 255), root of the mean square; moving hair that meets itself moves for every reason.");
  command->callback([options, &run] { run = [options] { runPlan(*options); }; });
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
  addSimulate(app, run);
  addRender(app, run);
  addMeasureMotion(app, run);
  addPlan(app, run);
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
  return hair::runReporting("hair", [&] { return hair::program(argc, argv); });
}

// The command lines of the commands that measure.
#include <memory>

#include <apps/common/command_line.h>
#include <apps/hair/options.h>

namespace hair {

void addMeasure(CLI::App& app, Run& run, const std::string& commandLine) {
  auto options = std::make_shared<MeasureOptions>();
  options->commandLine = commandLine;
  CLI::App* command = app.add_subcommand(
      "measure", "Measure error, time and memory of all shadow methods against ray-traced truth");
  addHairOptions(*command, options->character);
  command
      ->add_option("--width", options->width,
                   "of a strand, metres; default: the file's thickness or 80e-6, or the style's "
                   "hair width times the hairs a strand stands for (3 of 33500 strands)")
      ->check(within(1e-7, 0.1));
  command
      ->add_option("--alpha", options->alpha, "how opaque a strand is; default 0.6, or the style's")
      ->check(within(1e-4, 1));
  addVectors(
      *command, "--light", options->lights,
      "direction in which parallel light travels; repeat it for more; default 0.45,-0.8,-0.4");
  addVectors(*command, "--point", options->lamps,
             "position of a point light, metres; repeat it for more");
  command
      ->add_option("--footprint", options->footprints,
                   "radius of the disc that shadows are averaged over, metres; repeat it for more; "
                   "default 3e-3")
      ->expected(1)
      ->take_all()
      ->check(within(1e-6, 1));
  command->add_option("--samples", options->samples, "points that are compared; default 4000")
      ->check(CLI::Range(1, 10'000'000));
  command->add_option("--rays", options->rays, "of the truth, a sample; default 2048")
      ->check(CLI::Range(2, 1 << 22));
  command->add_option("--seed", options->seed, "of the choice of samples and rays; default 1");
  command->add_option("--methods", options->methods,
                      "all (default), quick (each once), or names with commas between: auto, "
                      "density-map, shadow-map, opacity-map, deep-opacity-map, "
                      "density-clustering, deep-shadow-map");
  command->add_option(
      "--max-error", options->maxError,
      "choose the fastest method and settings with at most this mean absolute error, say what is "
      "predicted of them and measure them as `chosen`");
  command->add_option("--budget-ms", options->budgetMs,
                      "choose the most accurate that builds and samples in so many milliseconds; "
                      "with --max-error: a limit of that choice too");
  command
      ->add_option("--repeats", options->repeats,
                   "timed runs of each method and setting, of which the median counts; default 5")
      ->check(CLI::Range(1, 10'000));
  command
      ->add_option("--flicker-steps", options->flickerSteps,
                   "steps of 0.1 degree that the light turns to see what flickers; 0: none; "
                   "default 20")
      ->check(CLI::Range(0, 10'000));
  command->add_option("--threads", options->threads, "0, the default: as many as the machine has")
      ->check(CLI::Range(0, 1024));
  command->add_option("--csv", options->csv, "a row a method, setting, light and footprint")
      ->check(endsWith(".csv"));
  command
      ->add_option("--dump", options->dump,
                   "a row a sample: strand,point,x,y,z,truth,truth_se, then each method and "
                   "setting; one light and one footprint only")
      ->check(endsWith(".csv"));
  command->add_option("--html", options->html, "a report with plots and pictures, one file")
      ->check(endsWith(".html"));
  command->footer(
      "Examples:\n"
      "  hair measure --style smooth --methods quick\n"
      "  hair measure --hair straight.hair --width 0.465e-3 --alpha 0.64 --html straight.html\n"
      "  hair measure --style curly --light 0,-1,0 --point 0.5,1,0.5 --footprint 3e-3 \\\n"
      "      --footprint 1e-2 --csv curly.csv --html curly.html\n"
      "  hair measure --style curly --methods auto --max-error 0.015\n"
      "Errors are of transmittance: 0 is dark, 1 is lit.");
  command->callback([options, &run] { run = [options] { runMeasure(*options); }; });
}

void addMeasureMotion(CLI::App& app, Run& run) {
  auto options = std::make_shared<MeasureMotionOptions>();
  CLI::App* command = app.add_subcommand(
      "measure-motion", "Measure error and time of the motion over substeps and numbers of guides");
  addCharacterOptions(*command, options->character);
  addPlayerOptions(*command, options->player, options->threads);
  SimulationTrialSettings& trial = options->trial;
  command->add_option("--frames", trial.frames, "frames of every run; default 120")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--early", trial.earlyFrames,
                   "frames at the start, and at the end, that errors are averaged over; default 30")
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
                   "of the links' solver a substep, beside the usual 2; default 1,4")
      ->delimiter(',')
      ->check(CLI::Range(1, 32));
  command
      ->add_option("--relaxation", trial.relaxation,
                   "iterations of the relaxation solver, at the usual substeps; default "
                   "1,2,4,8,16,32")
      ->delimiter(',')
      ->check(CLI::Range(1, 32));
  command
      ->add_option("--guide-counts", options->guideCounts,
                   "guides that the drawn strands are bound to; default 402,201,100,50,25")
      ->delimiter(',')
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--csv", options->csv, "the same table, a row a setting")
      ->check(endsWith(".csv"));
  command
      ->add_option("--plot", options->plot,
                   "error and stretch of the motion against time, a picture")
      ->check(endsWith(".svg"));
  command->footer(
      "Examples:\n"
      "  hair measure-motion --style smooth --csv motion.csv --plot motion.svg\n"
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
  CLI::App* command = app.add_subcommand(
      "plan", "Measure what each feature costs in a scene, and what a frame without it saves");
  addCharacterOptions(*command, options->character);
  addPlayerOptions(*command, options->player, options->threads);
  command
      ->add_option("--frames", options->frames,
                   "frames that are timed, of each variant; default 120")
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

}  // namespace hair

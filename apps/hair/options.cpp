// The command lines of the commands that do not measure, and all commands together.
#include <apps/hair/options.h>

#include <memory>

#include <apps/common/command_line.h>

namespace hair {

namespace {

// Checks the name of a file of strands to write: the format is known, the folder there.
std::string strandsToWrite(const std::string& name) {
  if (!isStrandFile(name)) return "must end with one of " + strandFormats() + ": " + name;
  if (!isWrittenStrandFile(name)) return "this format is read, not written: " + name;
  return endsWith("")(name);
}

void addInfo(CLI::App& app, Run& run) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a file holds");
  command
      ->add_option("FILE", options->file,
                   "strands (.hair, .tfx, .data, .ply, .obj, .usda, .npy, .npz, .pbrt), a mesh "
                   "(.obj) or a motion (.bvh)")
      ->required();
  addReadOptions(*command, options->read);
  addMotionReadOptions(*command, options->clip);
  command->add_flag("--verbose", options->verbose, "say each repair of a motion by itself");
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
      app.add_subcommand("convert", "Write strands of any format in any other, in metres, +Y up");
  command
      ->add_option("IN", options->in,
                   ".hair, .tfx, .data, .ply, .obj, .usda, .npy, .npz or .pbrt; name.####.hair: "
                   "all that are numbered so")
      ->required();
  command
      ->add_option("OUT", options->out,
                   "file to write, of these but .npy, .npz and .pbrt; .usda, and name.####.hair, "
                   "take every frame")
      ->required()
      ->check(strandsToWrite);
  addReadOptions(*command, options->read);
  command->add_option("--out-scale", options->write.scale, "metres per unit of OUT; default 1")
      ->check(within(1e-9, 1e9));
  addUpOption(*command, "--out-up", options->write.up, "axis of OUT that points up; default y");
  command
      ->add_option("--frame", options->frame,
                   "this frame only, from 0; default: all, or the first where OUT holds one")
      ->check(CLI::Range(0, 1'000'000'000));
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
      ->check(within(0, 1e6));
  command->footer(
      "Examples:\n"
      "  hair convert sintel.tfx sintel.hair\n"
      "  hair convert strands.data light.hair --strands 2000 --points 32\n"
      "  hair convert shot.usda shot.####.ply --out-up z-back\n"
      "Colours, thickness and transparency come along where OUT has room for them.");
  command->callback([options, &run] { run = [options] { runConvert(*options); }; });
}

void addSimulate(CLI::App& app, Run& run) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Simulate hair; write strands, times, statistics or a hash");
  addCharacterOptions(*command, options->character);
  addPlayerOptions(*command, options->player, options->threads);
  command->add_option("--frames", options->frames, "frames to simulate; default 120")
      ->check(CLI::Range(1, 10'000'000));
  command
      ->add_option("--cache,--out", options->cache,
                   "writes the strands of every frame: in one file, .usda, or in numbered files, "
                   "shot.####.hair (also .ply, .obj ...; shot.hair is numbered, too)")
      ->check(strandsToWrite);
  command
      ->add_option("--load-state", options->loadState,
                   "start from a state of the same hair that --save-state wrote, at its time")
      ->check(CLI::ExistingFile);
  command->add_option("--save-state", options->saveState, "writes the state after the last frame");
  addResultOptions(*command, options->results);
  command->footer(
      "Examples:\n"
      "  hair simulate --style smooth --frames 600 --hash\n"
      "  hair simulate --hair sintel.tfx --head sintel.obj --motion dance.bvh --cache sintel.usda\n"
      "  hair simulate --style curly --profile times.csv --stats stats.csv");
  command->callback([options, &run] { run = [options] { runSimulate(*options); }; });
}

void addRender(CLI::App& app, Run& run) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw one picture of hair under any light");
  addCharacterOptions(*command, options->character);
  addPlayerOptions(*command, options->player, options->threads);
  command
      ->add_option("--out", options->out,
                   "the picture: .png, or .exr (linear light, not clipped at 1)")
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
  for (std::size_t i = 0; i < kInsideCount; ++i) {
    std::string option = text("--show-", insideName(static_cast<Inside>(i)));
    std::replace(option.begin(), option.end(), ' ', '-');
    command->add_flag(option, options->shown.insides[i], insideMeaning(static_cast<Inside>(i)));
  }
  command->add_flag("--show-mesh", options->shown.mesh,
                    "draw the hair mesh that the hair was grown in: scalp green, tips purple");
  command->add_flag("--show-mesh-inside", options->shown.meshInside, "and its interior, red");
  command->add_flag("--mesh-surface", options->shown.meshSurface,
                    "draw the hair mesh's surface in place of the hair");
  command->add_flag("--show-cells", options->shown.cells,
                    "occupied cells of the first light's map, coloured by transmittance");
  command->footer(
      "Examples:\n"
      "  hair render --style smooth --out smooth.png --side-by-side --width 1600 --height 800\n"
      "  hair render --hair sintel.tfx --head sintel.obj --light 0.5,-0.8,-0.35 --out sintel.png\n"
      "  hair render --style curly --motion dance.bvh --frames 300 --out frame300.exr\n"
      "  hair render --light 0.9,-0.3,-0.3,1.3,0.7,0.3 --point -0.5,1.8,0.3,0.3,0.6,1.2 --out "
      "a.png\n"
      "In a picture head and body shadow the hair for every light; the first four lights shine\n"
      "on head, body and floor, where one at a point casts shadows within 75 degrees of the way\n"
      "to the head.");
  command->callback([options, &run] { run = [options] { runRender(*options); }; });
}

}  // namespace

void addCommands(CLI::App& app, Run& run, const std::string& commandLine) {
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 bad input, 2 bad usage.");
  addInfo(app, run);
  addConvert(app, run);
  addSimulate(app, run);
  addRender(app, run);
  addMeasure(app, run, commandLine);
  addMeasureMotion(app, run);
  addPlan(app, run);
  addLod(app, run);
#ifdef HAIR_WITH_HAIR_MESH
  addMesh(app, run);
#endif
}

}  // namespace hair

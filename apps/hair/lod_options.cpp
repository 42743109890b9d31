#include <memory>

#include <apps/common/command_line.h>
#include <apps/hair/options.h>

namespace hair {

void addLod(CLI::App& app, Run& run) {
  auto options = std::make_shared<LodOptions>();
  CLI::App* command = app.add_subcommand(
      "lod", "Measure what levels of detail leave out on a small head: time saved and error");
  addCharacterOptions(*command, options->character);
  addPlayerOptions(*command, options->player, options->threads);
  command
      ->add_option("--sizes", options->sizes,
                   "heights of the head in the picture, pixels; default 800,400,200,100,50")
      ->delimiter(',')
      ->check(within(4, 2000));
  command->add_option("--importance", options->importance, "of the head, (0, 1]; default 1")
      ->check(within(1e-3, 1));
  command
      ->add_option("--strands-per-pixel", options->detail.strandsPerPixel,
                   "strands of the groom per pixel of the head's height")
      ->check(within(1e-3, 1e6));
  command
      ->add_option("--pixels-off", options->detail.pixelsOff,
                   "how far strands may be from where they were, pixels")
      ->check(within(1e-6, 1e3));
  command
      ->add_option("--pixels-per-cell", options->detail.pixelsPerCell,
                   "what a cell of a shadow map measures at least")
      ->check(within(0, 1e3));
  command
      ->add_option("--fade", options->detail.fade,
                   "strands on their way out, as a share of the others, (0, 1]")
      ->check(within(1e-3, 1));
  command->add_option("--frames", options->frames, "timed frames of each level; default 30")
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--yaw", options->yaw, "degrees about the head, 0: before the face")
      ->check(within(-360, 360));
  command->add_option("--pitch", options->pitch, "degrees from above")->check(within(-89.0, 89.0));
  command
      ->add_option("--sheet", options->sheet,
                   "pictures at each size: all of the hair, the level, ten times the difference")
      ->check(endsWith(".png"));
  command->add_option("--csv", options->csv, "the same table, a row a size")
      ->check(endsWith(".csv"));
  command->footer(
      "Examples:\n"
      "  hair lod --style smooth --strands 33500 --sheet smooth.png\n"
      "  hair lod --hair sintel.tfx --head sintel.obj --sizes 400,100 --csv sintel.csv\n"
      "shadow: transmittance against the whole hair's map at the same points. picture: luminance\n"
      "against the whole hair, of the same size, as shares of the hair's mean. 1 % on: how much "
      "the\n"
      "picture changes where the level is that of a head 1 % smaller; abrupt: without fading.");
  command->callback([options, &run] { run = [options] { runLod(*options); }; });
}

}  // namespace hair

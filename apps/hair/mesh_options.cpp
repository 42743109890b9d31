// The command line of `hair mesh`.
#include <memory>

#include <apps/common/command_line.h>
#include <apps/hair/options.h>

namespace hair {

void addMesh(CLI::App& app, Run& run) {
  CLI::App* mesh = app.add_subcommand("mesh", "Hair modelled as a polygon volume: hair meshes");
  mesh->require_subcommand(1);

  auto apply = std::make_shared<MeshApplyOptions>();
  CLI::App* command = mesh->add_subcommand("apply", "Build the hair mesh that a script describes");
  command->add_option("SCRIPT", apply->script, "a .hairmesh file")->required();
  command->add_option("--out", apply->out, "the hair mesh, .obj: one object a layer")
      ->required()
      ->check(endsWith(".obj"));
  command->add_option("--hair", apply->hair, "strands of all its groups, .hair")
      ->check(endsWith(".hair"));
  command->footer(
      "Examples:\n"
      "  hair mesh apply bob.hairmesh --out bob.obj --hair bob.hair\n"
      "  hair render --hair bob.hair --out bob.png\n"
      "Files that a script names stand beside it. docs/formats.md lists its operations.");
  command->callback([apply, &run] { run = [apply] { runMeshApply(*apply); }; });

  auto info = std::make_shared<MeshInfoOptions>();
  command = mesh->add_subcommand("info", "Say what a hair mesh holds");
  command->add_option("FILE", info->file, ".obj with an object a layer, or a .hairmesh script")
      ->required();
  command->callback([info, &run] { run = [info] { runMeshInfo(*info); }; });
}

}  // namespace hair

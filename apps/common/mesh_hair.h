#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <libhair/core/transform.h>
#include <libhair/files/strand_file.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/hair_mesh.h>
#include <libhair/model/groom.h>

namespace hair {

struct CharacterOptions;

/// Whether a file is a hair mesh: a script (.hairmesh), or layers, an .obj without lines.
inline bool isHairMeshScript(const std::filesystem::path& file) {
  return file.extension() == ".hairmesh";
}
inline bool isHairMesh(const std::filesystem::path& file) {
  const bool obj = file.extension() == ".obj" || file.extension() == ".OBJ";
  return isHairMeshScript(file) || (obj && !holdsStrands(file));
}

/// Hair that is modelled as a mesh, and the strands grown in it.
struct MeshHair {
  HairMesh mesh;
  std::vector<StrandGroup> groups;
  std::vector<std::uint32_t> tied;  ///< Hairstyle::tied
  GrownHair grown;
};

/// Units and axes of a hair mesh: metres, +Y up, unless --scale and --up say otherwise.
ReadOptions meshUnits(const CharacterOptions& options);

/// Reads or builds the mesh of options.hair and grows its groups; of an .obj, which has none, one
/// group as StrandGroup has it. --strands and --points count for the groups together and for each.
/// Throws Error (file, line, cause), and where hair meshes were left out of the build.
MeshHair growMeshHair(const CharacterOptions& options, std::vector<std::string>& notes);

/// Moves mesh and strands with the head they grow on.
void moveBy(const RigidTransform& to, MeshHair& hair);

/// The groom that is simulated: chains of the mesh are its guides.
Groom groomOf(const MeshHair& hair);

}  // namespace hair

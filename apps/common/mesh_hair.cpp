#include <apps/common/mesh_hair.h>

#include <algorithm>
#include <cmath>

#include <apps/common/character.h>
#include <libhair/core/error.h>
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <libhair/hair_mesh/mesh_groom.h>
#include <libhair/hair_mesh/script/script.h>

namespace hair {

namespace {

// So many strands in all, each group the share that it has; the rest is the first group's.
void askFor(std::uint32_t strands, MeshHair& hair) {
  const double all = static_cast<double>(hair.grown.strands.strandCount());
  std::uint32_t left = strands;
  for (std::size_t g = hair.groups.size(); g-- > 0;) {
    const double share = static_cast<double>(hair.grown.roots[g].rootCount()) / all;
    const auto asked = static_cast<std::uint32_t>(std::round(strands * share));
    hair.groups[g].strands = g > 0 ? std::min(left, asked) : left;
    hair.groups[g].perSquareMetre = 0;
    left -= hair.groups[g].strands;
  }
  std::erase_if(hair.groups, [](const StrandGroup& group) { return group.strands == 0; });
  hair.grown = growHair(hair.mesh, hair.groups);
}

Hairstyle styleOf(const CharacterOptions& options) {
  if (isHairMeshScript(options.hair))
    return applyScript(readHairMeshScript(options.hair), filesBeside(options.hair));
  return {readHairMesh(options.hair), {}, {}};
}

}  // namespace

ReadOptions meshUnits(const CharacterOptions& options) {
  return {options.read.scale > 0 ? options.read.scale : 1,
          options.read.up == UpAxis::AsFile ? UpAxis::Y : options.read.up};
}

MeshHair growMeshHair(const CharacterOptions& options, std::vector<std::string>& notes) {
  MeshHair hair;
  Hairstyle style = styleOf(options);
  hair.mesh = std::move(style.mesh);
  // Before anything grows: groups count strands a square metre.
  const ReadOptions read = meshUnits(options);
  for (HairMesh::Layer& layer : hair.mesh.layers)
    convertUnits(layer.positions, read.scale, read.up);
  hair.groups = std::move(style.groups);
  hair.tied = std::move(style.tied);
  const std::string name = options.hair.filename().string();
  if (hair.groups.empty()) {
    hair.groups.emplace_back();
    notes.push_back(text(name, ": no groups of strands; ", hair.groups.front().strands,
                         " without styling (--strands asks for others)"));
  }
  if (options.points > 0)
    for (StrandGroup& group : hair.groups) group.points = options.points;
  hair.grown = growHair(hair.mesh, hair.groups);
  if (options.strands > 0) askFor(options.strands, hair);
  notes.push_back(text(name, ": ", hair.mesh.vertexCount(), " vertices in ", hair.mesh.layerCount(),
                       " layers, ", hair.mesh.bundleCount(), " bundles; ",
                       hair.grown.strands.strandCount(), " strands"));
  return hair;
}

Groom groomOf(const MeshHair& hair) {
  return makeGroom(hair.mesh, hair.grown.roots, hair.grown.strands, {.tied = hair.tied});
}

void moveBy(const RigidTransform& to, MeshHair& hair) {
  for (HairMesh::Layer& layer : hair.mesh.layers)
    for (glm::vec3& p : layer.positions) p = to.point(p);
  for (glm::vec3& p : hair.grown.strands.points) p = to.point(p);
  for (HairMeshRoots& roots : hair.grown.roots)
    for (glm::vec3& p : roots.positions) p = to.point(p);
}

}  // namespace hair

#include <algorithm>

#include <apps/draw/image.h>
#include <apps/hair/commands.h>
#include <apps/hair/info_rows.h>
#include <libhair/core/error.h>
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/script/script.h>
#include <libhair/hair_mesh/surface.h>

namespace hair {

namespace {

Hairstyle styleOf(const std::filesystem::path& script) {
  return applyScript(readHairMeshScript(script), filesBeside(script));
}

// A picture over the scalp from above.
ScalpDensity densityOf(const std::filesystem::path& picture, const HairMesh& mesh) {
  if (picture.empty()) return {};
  draw::Mask mask = draw::readMask(picture);
  const Bounds scalp = bounds(mesh.layers.front().positions);
  require(scalp.lower.x < scalp.upper.x && scalp.lower.z < scalp.upper.z,
          "--density: seen from above the scalp has no area");
  return DensityImage{static_cast<std::uint32_t>(mask.width),
                      static_cast<std::uint32_t>(mask.height),
                      std::move(mask.values),
                      {scalp.lower.x, scalp.lower.z},
                      {scalp.upper.x, scalp.upper.z}};
}

}  // namespace

void runMeshApply(const MeshApplyOptions& options) {
  const Hairstyle style = styleOf(options.script);
  require(options.hair.empty() || !style.groups.empty(), options.script.string(),
          ": no strands for --hair: the script has no line `group strands N`");
  require(options.density.empty() || !options.hair.empty(),
          "--density: it says where strands grow; ask for them with --hair too");
  writeHairMesh(options.out, style.mesh);
  std::cout << options.out.string() << ": " << style.mesh.bundleCount() << " bundles, "
            << style.mesh.layerCount() << " layers, " << style.mesh.vertexCount() << " vertices\n";
  if (options.hair.empty()) return;
  const GrownHair hair = growHair(style.mesh, style.groups, densityOf(options.density, style.mesh));
  writeStrands(options.hair, hair.strands);
  std::cout << options.hair.string() << ": " << hair.strands.strandCount() << " strands, "
            << hair.strands.pointCount() << " points, groups: " << style.groups.size() << '\n';
}

void runMeshInfo(const MeshInfoOptions& options) {
  const bool isScript = options.file.extension() == ".hairmesh";
  Hairstyle style;
  if (isScript)
    style = styleOf(options.file);
  else
    style.mesh = readHairMesh(options.file);
  const HairMesh& mesh = style.mesh;

  std::vector<float> layers, lengths, sides;
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j) {
    float length = 0;  // mean of its edges
    for (std::uint32_t k = 1; k <= mesh.lastLayer[j]; ++k)
      for (std::size_t i = 0; i < mesh.sides(j); ++i)
        length += glm::distance(mesh.layers[k].positions[mesh.face(k, j)[i]],
                                mesh.layers[k - 1].positions[mesh.face(k - 1, j)[i]]);
    lengths.push_back(length / static_cast<float>(mesh.sides(j)));
    layers.push_back(static_cast<float>(mesh.lastLayer[j]));
    sides.push_back(static_cast<float>(mesh.sides(j)));
  }
  std::vector<glm::vec3> points;
  std::size_t exterior = 0;
  const auto outside = exteriorVertices(mesh);
  for (std::size_t k = 0; k < mesh.layerCount(); ++k) {
    const auto& positions = mesh.layers[k].positions;
    points.insert(points.end(), positions.begin(), positions.end());
    exterior += static_cast<std::size_t>(std::count(outside[k].begin(), outside[k].end(), 1));
  }
  const auto printRange = [](const Quantiles& q, const char* unit) {
    std::cout << q.least << " to " << q.most << unit << ", median " << q.median << unit << '\n';
  };
  std::cout << std::setprecision(4);
  row("file") << options.file.string() << '\n';
  row("format") << (isScript ? ".hairmesh: a script" : ".obj: a hair mesh, one object a layer")
                << "; metres, +Y up, +Z face\n";
  row("bundles") << mesh.bundleCount() << '\n';
  row("sides"), printRange(quantiles(sides), "");
  row("layers") << mesh.layerCount() << "; above the scalp, a bundle: ";
  printRange(quantiles(layers), "");
  row("vertices") << mesh.vertexCount() << ": " << exterior << " exterior, "
                  << mesh.vertexCount() - exterior << " interior\n";
  row("length"), printRange(quantiles(lengths), " m");
  printBounds(points);
  for (const StrandGroup& group : style.groups)
    row("group") << group.strands << " strands of " << group.points << " points\n";
}

}  // namespace hair

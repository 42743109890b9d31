// Models hair on a sphere as a hair mesh, grows strands in it and writes them.
//
//   example_hair_from_mesh OUT.hair        then look: dance --hair OUT.hair, or hair render
//
// Look at: how few lines shape the volume, and that interior vertices are nobody's work.
#include <exception>
#include <iostream>
#include <numeric>

#include <libhair/files/strand_file.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/hair_mesh/scalp_patch.h>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: example_hair_from_mesh OUT.hair\n";
    return 2;
  }
  // The upper part of a sphere as big as a head, in 4 rings of 16 faces.
  hair::HairMesh mesh =
      hair::makeHairMesh(hair::sphereScalp({.rings = 4, .sectors = 16}, 0.095f, 100));

  // Three layers of 5 cm on every face, which sink under their weight.
  std::vector<std::uint32_t> all(mesh.bundleCount());
  std::iota(all.begin(), all.end(), 0u);
  for (std::uint32_t layer = 1; layer <= 3; ++layer) {
    hair::extrudeFaces(all, 0.05f, mesh);
    for (glm::vec3& p : mesh.layers[layer].positions) p.y -= 0.02f * static_cast<float>(layer);
  }
  const hair::PlacementResult placed = hair::placeInterior(mesh);
  std::cout << mesh.vertexCount() << " vertices; interior ones placed in " << placed.iterations
            << " iterations\n";

  // Locks, and some strands that stand off.
  std::vector<hair::StrandGroup> groups(2);
  groups[0].strands = 5000;
  groups[0].styling = {.lengthVariation = 0.1f, .clump = 0.6f, .noise = 0.006f};
  groups[1].strands = 300;
  groups[1].seed = 2;
  groups[1].styling = {.noise = 0.01f, .frizz = 0.002f};
  const hair::GrownHair grown = hair::growHair(mesh, groups);
  hair::writeStrands(argv[1], grown.strands);
  std::cout << grown.strands.strandCount() << " strands in " << argv[1] << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

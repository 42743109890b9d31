#include <benchmarks/hair_mesh_table.h>

#include <cmath>
#include <iomanip>
#include <iostream>

#include <libhair/core/parallel.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/mesh_groom.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/model/head.h>
#include <libhair/simulation/frame.h>

namespace hair {

namespace {

// A patch of columns x rows quads on the back of the built-in head, and layers that hang from it.
HairMesh patch(std::uint32_t columns, std::uint32_t rows, std::uint32_t layers, float length) {
  PolygonMesh scalp;
  for (std::uint32_t z = 0; z <= rows; ++z)
    for (std::uint32_t x = 0; x <= columns; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(columns) - 0.5f;
      const float v = static_cast<float>(z) / static_cast<float>(rows);
      scalp.positions.emplace_back(0.1f * u, 0.17f - 0.08f * v, -0.09f - 0.02f * v);
    }
  for (std::uint32_t z = 0; z < rows; ++z)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = z * (columns + 1) + x, b = a + columns + 1;
      scalp.corners.insert(scalp.corners.end(), {a, a + 1, b + 1, b});
      scalp.firstCorner.push_back(static_cast<std::uint32_t>(scalp.corners.size()));
    }
  HairMesh mesh = makeHairMesh(scalp);
  std::vector<std::uint32_t> all(mesh.bundleCount());
  for (std::uint32_t j = 0; j < all.size(); ++j) all[j] = j;
  const float step = length / static_cast<float>(layers);
  for (std::uint32_t k = 1; k <= layers; ++k) {
    extrudeFaces(all, step, mesh);
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
      mesh.layers[k].positions[v] = mesh.layers[k - 1].positions[mesh.layers[k].below[v]] +
                                    step * glm::normalize(glm::vec3(0, -1, -1.0f / float(k)));
  }
  return mesh;
}

double framesASecond(const HairMesh& mesh, std::uint32_t pointsPerGuide, std::uint32_t strands,
                     int frames) {
  const StrandGroup group{.strands = strands, .points = 32};
  const GrownHair grown = growHair(mesh, {&group, 1});
  const Groom groom =
      makeGroom(mesh, grown.roots, grown.strands, {.pointsPerGuide = pointsPerGuide});
  static const MeshSdf head(builtinHead().mesh);
  FrameSettings settings;
  settings.shadow = settings.shade = settings.selfCollision = false;
  Hair hair(groom, settings, {}, &head);
  FrameProfile profile{};
  ProfileLog log;
  RigidTransform pose;
  for (int f = 0; f < frames; ++f) {
    pose.rotation =
        glm::angleAxis(0.5f * std::sin(0.1f * static_cast<float>(f)), glm::vec3(0, 1, 0));
    profile = {};
    frame({pose, {}}, settings, 1.0f / 60, hair, profile);
    log.add(profile);
  }
  return 1000 / log.milliseconds(Stage::Motion, Stage::Wisps, 0.5);
}

}  // namespace

void printHairMeshTable(int frames) {
  const ThreadLimit one(1);
  std::cout << "\nSimulation on a hair mesh (Yuksel et al. 2009, section 4), one thread, frames a "
               "second\n";
  const auto row = [&](const char* name, const HairMesh& mesh, std::uint32_t points,
                       std::uint32_t strands) {
    const HairMeshChains chains = chainsOf(mesh);
    std::cout << std::left << std::setw(28) << name << std::right << std::setw(6)
              << mesh.vertexCount() << " vertices, " << mesh.layerCount() << " layers, "
              << chains.chainCount() << " chains of " << points - 1 << " links, " << strands
              << " strands:" << std::setw(10) << std::setprecision(0)
              << framesASecond(mesh, points, strands, frames) << '\n';
  };
  // Five layers of 30 vertices have 30 chains and 120 links between layers; the paper says it the
  // other way round ("30 rigid body links and 120 chains"), so both are here.
  const HairMesh paper = patch(5, 4, 4, 0.25f);
  row("the mesh's chains", paper, 5, 1);
  row("and strands", paper, 5, 10'000);
  row("120 chains of 30 links", patch(11, 9, 4, 0.25f), 31, 1);
  std::cout << "paper, 2.14 GHz Core 2 Duo, one thread: 92\n";
}

}  // namespace hair

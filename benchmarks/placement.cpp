// Interior placement of hair meshes of 150 to 50,000 vertices: what it costs to assemble, to place
// all interior vertices anew, and to follow one exterior vertex that is dragged; beside it, where
// it was found, Ceres on the same sum. Milliseconds, one thread.
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string_view>

#include <benchmarks/timing.h>
#include <libhair/core/error.h>
#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/surface.h>
#include <tests/hair_mesh/sample_meshes.h>

#ifdef HAIR_BENCH_CERES
#include <tests/hair_mesh/ceres_placement.h>
#endif

namespace hair::bench {
namespace {

constexpr std::string_view kHelp = R"(benchmark_placement [MOST]

Interior placement of hair meshes of 150 to MOST vertices (50000): milliseconds to assemble it, to place
all interior vertices anew, and to follow one exterior vertex that is dragged; beside them Ceres on the
same sum, where it was found.

  -h, --help     this
)";

// A grid of columns x rows bundles whose layers widen, fall over and wave.
HairMesh waves(std::uint32_t columns, std::uint32_t rows, std::uint32_t layers) {
  const auto upTo = [](float size, std::uint32_t parts) {
    return size / static_cast<float>(parts);
  };
  HairMesh mesh = test::stack(test::gridScalp(columns, rows, 1), layers, {0, 1, 0});
  for (HairMesh::Layer& layer : mesh.layers)
    for (glm::vec3& p : layer.positions) {
      const float x = p.x * upTo(0.2f, columns) - 0.1f, z = p.z * upTo(0.2f, rows) - 0.1f;
      const float s = p.y * upTo(0.3f, layers);
      p = {x * (1 + 2 * s) + s * s, s - 2 * s * s + 0.02f * std::sin(20 * x + 9 * s),
           z * (1 + s) + 0.03f * std::sin(15 * s + 5 * z)};
    }
  return mesh;
}

// All interior vertices at one place: nothing is known of them.
void forget(HairMesh& mesh) {
  const auto exterior = exteriorVertices(mesh);
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
      if (exterior[k][v] == 0) mesh.layers[k].positions[v] = mesh.layers[0].positions[0];
}

// The middle of one side of the mesh, half-way up, a centimetre out and in again.
void drag(HairMesh& mesh, int move) {
  const std::vector<glm::vec3>& scalp = mesh.layers[0].positions;
  const auto fromMiddleOfSide = [](glm::vec3 p) {
    return std::abs(p.x) + 10 * std::abs(p.z + 0.1f);
  };
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < scalp.size(); ++v)
    if (fromMiddleOfSide(scalp[v]) < fromMiddleOfSide(scalp[nearest])) nearest = v;
  mesh.layers[mesh.layerCount() / 2].positions[nearest].z += move % 2 == 0 ? -0.01f : 0.01f;
}

double farthest(const HairMesh& a, const HairMesh& b) {
  float most = 0;
  for (std::size_t k = 0; k < a.layerCount(); ++k)
    for (std::size_t v = 0; v < a.layers[k].vertexCount(); ++v)
      most = std::max(most, glm::distance(a.layers[k].positions[v], b.layers[k].positions[v]));
  return most;
}

HairMesh exact(HairMesh mesh) {
  PlacementSettings settings;
  settings.tolerance = 1e-13f;
  placeInterior(mesh, settings);
  return mesh;
}

struct Work {
  std::uint32_t columns, rows, layers;
};

void measure(const Work& work) {
  const HairMesh posed = waves(work.columns, work.rows, work.layers);
  const int repeats = posed.vertexCount() > 20'000 ? 5 : 15;
  const double assembly = medianSeconds(repeats, [&] { InteriorPlacement placement(posed); });
  InteriorPlacement placement(posed);

  HairMesh mesh;
  std::vector<double> cold, dragged;
  std::uint32_t coldIterations = 0;
  std::vector<double> dragIterations;
  for (int i = 0; i < repeats; ++i) {
    mesh = posed;
    forget(mesh);
    cold.push_back(secondsOf([&] { coldIterations = placement.place(mesh).iterations; }));
  }
  const double coldOff = farthest(mesh, exact(mesh));
  for (int i = 0; i < repeats; ++i) {
    drag(mesh, i);
    PlacementResult result;
    dragged.push_back(secondsOf([&] { result = placement.place(mesh); }));
    dragIterations.push_back(result.iterations);
  }
  const double dragOff = farthest(mesh, exact(mesh));

  std::cout << std::fixed << std::setw(8) << posed.vertexCount() << std::setw(8) << work.layers + 1
            << std::setw(8) << placement.freeCount() << std::setprecision(2) << std::setw(10)
            << 1e3 * assembly << std::setw(8) << coldIterations << std::setw(10)
            << 1e3 * median(cold) << std::setw(8) << std::setprecision(0) << median(dragIterations)
            << std::setprecision(2) << std::setw(10) << 1e3 * median(dragged) << std::setw(10)
            << 1e6 * std::max(coldOff, dragOff);
#ifdef HAIR_BENCH_CERES
  HairMesh other = posed;
  forget(other);
  test::CeresPlacement peer(other);
  const double first = secondsOf([&] { peer.place(ceres::CGNR, other); });
  const double firstOff = farthest(other, exact(other));
  std::vector<double> again;
  for (int i = 0; i < (repeats > 5 ? 5 : 1); ++i) {
    drag(other, i);
    again.push_back(secondsOf([&] { peer.place(ceres::CGNR, other); }));
  }
  const double againOff = farthest(other, exact(other));
  std::cout << std::setw(10) << 1e3 * first << std::setw(10) << 1e3 * median(again)
            << std::setprecision(0) << std::setw(8) << median(again) / median(dragged)
            << std::setprecision(2) << std::setw(10) << 1e6 * std::max(firstOff, againOff);
#endif
  std::cout << std::endl;
}

int program(std::size_t most) {
  std::cout << std::setw(24) << "" << std::setw(10) << "assembly" << std::setw(18) << "cold"
            << std::setw(18) << "drag" << std::setw(10) << "off, um";
#ifdef HAIR_BENCH_CERES
  std::cout << std::setw(38) << "Ceres CGNR";
#endif
  std::cout << '\n'
            << std::setw(8) << "vertices" << std::setw(8) << "layers" << std::setw(8) << "free"
            << std::setw(10) << "ms" << std::setw(8) << "steps" << std::setw(10) << "ms"
            << std::setw(8) << "steps" << std::setw(10) << "ms" << std::setw(10) << "";
#ifdef HAIR_BENCH_CERES
  std::cout << std::setw(10) << "first, ms" << std::setw(10) << "drag, ms" << std::setw(8)
            << "times" << std::setw(10) << "off, um";
#endif
  std::cout << '\n';
  for (const Work& work :
       {Work{5, 4, 4}, Work{9, 9, 9}, Work{24, 19, 9}, Work{39, 24, 9}, Work{99, 49, 9}}) {
    if ((work.columns + 1) * (work.rows + 1) * (work.layers + 1) <= most) measure(work);
  }
  return 0;
}

}  // namespace
}  // namespace hair::bench

int main(int argc, char** argv) {
  try {
    const std::string_view word = argc > 1 ? argv[1] : "";
    if (word == "--help" || word == "-h") {
      std::cout << hair::bench::kHelp;
      return 0;
    }
    const long most = argc > 1 ? std::atol(argv[1]) : 50'000;
    hair::require(most >= 150, "benchmark_placement: needs at least 150 vertices, got ", argv[1]);
    return hair::bench::program(static_cast<std::size_t>(most));
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}

#pragma once

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/operations.h>
#include <tests/hair_mesh/same_mesh.h>
#include <tests/hair_mesh/scalps.h>

// What tests of single operations ask of small meshes.
namespace hair::test {

using Numbers = std::vector<std::uint32_t>;

inline Numbers all(const HairMesh& mesh) {
  Numbers bundles(mesh.bundleCount());
  std::iota(bundles.begin(), bundles.end(), 0u);
  return bundles;
}

inline Numbers vertexCounts(const HairMesh& mesh) {
  Numbers counts;
  for (const auto& layer : mesh.layers)
    counts.push_back(static_cast<std::uint32_t>(layer.vertexCount()));
  return counts;
}

inline Numbers faceOf(const HairMesh& mesh, std::size_t layer, std::uint32_t bundle) {
  const auto face = mesh.face(layer, bundle);
  return Numbers(face.begin(), face.end());
}

// What the refusal of `operation` says; it must leave the mesh as it was.
template <class Operation>
std::string refusal(HairMesh& mesh, Operation operation) {
  const HairMesh before = mesh;
  try {
    operation();
  } catch (const Error& e) {
    EXPECT_TRUE(identical(before, mesh));
    return e.what();
  }
  return "nothing was refused";
}

// Vertex of a layer that stands on the scalp's vertex nearest to the place, in a bundle's face.
inline std::uint32_t vertexAt(const HairMesh& mesh, std::size_t layer, std::uint32_t bundle,
                              glm::vec3 place) {
  std::uint32_t best = kNoVertex;
  float least = std::numeric_limits<float>::max();
  for (std::uint32_t i = 0; i < mesh.sides(bundle); ++i)
    if (const float d = glm::distance(mesh.layers[0].positions[mesh.face(0, bundle)[i]], place);
        d < least) {
      least = d;
      best = mesh.face(layer, bundle)[i];
    }
  return best;
}

inline constexpr float kSize = 0.02f;  // of the grid's squares

// On a grid: the vertex at column x, row z.
inline std::uint32_t gridVertex(const HairMesh& mesh, std::size_t layer, std::uint32_t bundle,
                                int x, int z) {
  return vertexAt(mesh, layer, bundle, {kSize * float(x), 0, kSize * float(z)});
}

inline HairMeshEdge gridEdge(const HairMesh& mesh, std::size_t layer, std::uint32_t bundle, int x0,
                             int z0, int x1, int z1) {
  return {gridVertex(mesh, layer, bundle, x0, z0), gridVertex(mesh, layer, bundle, x1, z1)};
}

}  // namespace hair::test

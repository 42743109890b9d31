#pragma once

#include <libhair/hair_mesh/hair_mesh.h>

#include <cmath>

// Hair meshes made without the operations that tests of those would trust.
namespace hair::test {

/// columns x rows unit squares in the plane y = 0, scaled; seen from above counter-clockwise.
inline PolygonMesh gridScalp(std::uint32_t columns, std::uint32_t rows, float size = 0.02f) {
  PolygonMesh scalp;
  for (std::uint32_t z = 0; z <= rows; ++z)
    for (std::uint32_t x = 0; x <= columns; ++x)
      scalp.positions.emplace_back(size * static_cast<float>(x), 0, size * static_cast<float>(z));
  for (std::uint32_t z = 0; z < rows; ++z)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = z * (columns + 1) + x, b = a + columns + 1;
      scalp.corners.insert(scalp.corners.end(), {a, b, b + 1, a + 1});
      scalp.firstCorner.push_back(static_cast<std::uint32_t>(scalp.corners.size()));
    }
  return scalp;
}

/// The scalp and `layers` more of the same topology, each `step` beyond the one before.
inline HairMesh stack(const PolygonMesh& scalp, std::uint32_t layers,
                      glm::vec3 step = {0, 0.03f, 0}) {
  HairMesh mesh = makeHairMesh(scalp);
  for (std::uint32_t k = 1; k <= layers; ++k) {
    HairMesh::Layer layer = mesh.layers.back();
    layer.below.resize(layer.positions.size());
    for (std::uint32_t v = 0; v < layer.below.size(); ++v) {
      layer.below[v] = v;
      layer.positions[v] += step;
    }
    mesh.layers.push_back(std::move(layer));
  }
  for (std::uint32_t& last : mesh.lastLayer) last = layers;
  return mesh;
}

}  // namespace hair::test

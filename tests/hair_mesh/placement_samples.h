#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/surface.h>
#include <tests/hair_mesh/sample_meshes.h>

// Hair meshes with an inside, made without the operations that tests of those would trust.
namespace hair::test {

/// Every vertex moved by move(position, layer, vertex).
template <class Move>
HairMesh moved(HairMesh mesh, Move&& move) {
  for (std::uint32_t k = 0; k < mesh.layerCount(); ++k)
    for (std::uint32_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
      mesh.layers[k].positions[v] = move(mesh.layers[k].positions[v], k, v);
  return mesh;
}

/// Each vertex up to `by` metres away along each axis.
inline HairMesh shaken(const HairMesh& mesh, float by, std::uint32_t seed = 1) {
  return moved(mesh, [&](glm::vec3 p, std::uint32_t k, std::uint32_t v) {
    const auto random = [&](std::uint32_t axis) {
      return uniform(1000 * k + v, axis, seed) * 2 - 1;
    };
    return p + by * glm::vec3(random(0), random(1), random(2));
  });
}

/// The same, of vertices that are neither exterior nor pinned.
inline HairMesh shakenInside(const HairMesh& mesh, float by, std::uint32_t seed = 1) {
  const auto exterior = exteriorVertices(mesh);
  const HairMesh all = shaken(mesh, by, seed);
  return moved(mesh, [&](glm::vec3 p, std::uint32_t k, std::uint32_t v) {
    const bool held = exterior[k][v] != 0 || mesh.layers[k].pinned[v] != 0;
    return held ? p : all.layers[k].positions[v];
  });
}

/// Layers that widen, fall over and wave: nothing that a straight line would find.
inline HairMesh waved(const HairMesh& mesh) {
  return moved(mesh, [](glm::vec3 p, std::uint32_t, std::uint32_t) {
    return glm::vec3(p.x * (1 + 2 * p.y) + 2 * p.y * p.y,
                     p.y - p.y * p.y + 0.02f * std::sin(20 * p.x + 9 * p.y),
                     p.z * (1 + p.y) + 0.03f * std::sin(15 * p.y + 5 * p.z));
  });
}

/// Vertices of layer `layer` and above at places that `apart` names are parted: the bundles that
/// `other` names get vertices of their own there.
template <class Apart, class Other>
HairMesh forked(HairMesh mesh, std::size_t layer, Apart&& apart, Other&& other) {
  for (std::size_t k = layer; k < mesh.layerCount(); ++k) {
    HairMesh::Layer& at = mesh.layers[k];
    std::map<std::uint32_t, std::uint32_t> copies;
    for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
      if (!other(j)) continue;
      for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
        const std::uint32_t v = at.corners[c];
        if (v == kNoVertex || !apart(at.positions[v])) continue;
        const auto [copy, isNew] =
            copies.emplace(v, static_cast<std::uint32_t>(at.positions.size()));
        if (isNew) {
          at.positions.push_back(at.positions[v]);
          at.pinned.push_back(at.pinned[v]);
        }
        at.corners[c] = copy->second;
      }
    }
    at.below.assign(at.positions.size(), kNoVertex);
    for (std::size_t c = 0; c < mesh.cornerCount(); ++c)
      if (at.corners[c] != kNoVertex) at.below[at.corners[c]] = mesh.layers[k - 1].corners[c];
  }
  return mesh;
}

/// The same mesh, `bundle` ending in `layer`; for bundles inside, whose vertices others use.
inline HairMesh ending(HairMesh mesh, std::size_t bundle, std::uint32_t layer) {
  mesh.lastLayer[bundle] = layer;
  for (std::size_t k = layer + 1; k < mesh.layerCount(); ++k)
    for (std::uint32_t c = mesh.firstCorner[bundle]; c < mesh.firstCorner[bundle + 1]; ++c)
      mesh.layers[k].corners[c] = kNoVertex;
  return mesh;
}

/// A middle vertex, a ring of triangles around it and two rings of quads, as flat as a plate.
inline PolygonMesh plate(std::uint32_t sides, float radius = 0.03f) {
  PolygonMesh scalp;
  scalp.positions.emplace_back(0);
  for (std::uint32_t ring = 1; ring <= 3; ++ring)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const float a = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides);
      scalp.positions.emplace_back(radius * static_cast<float>(ring) *
                                   glm::vec3(std::cos(a), 0, -std::sin(a)));
    }
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 1 + ring * sides + i % sides; };
  const auto add = [&](std::initializer_list<std::uint32_t> face) {
    scalp.corners.insert(scalp.corners.end(), face);
    scalp.firstCorner.push_back(static_cast<std::uint32_t>(scalp.corners.size()));
  };
  for (std::uint32_t i = 0; i < sides; ++i) add({0, at(0, i), at(0, i + 1)});
  for (std::uint32_t ring = 0; ring < 2; ++ring)
    for (std::uint32_t i = 0; i < sides; ++i)
      add({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)});
  return scalp;
}

/// A closed scalp: the surface of a cube, sides x sides squares on each of its faces, and `layers`
/// more around it. There is no edge to it, so that only scalp and tips are exterior.
inline HairMesh ball(std::uint32_t sides, std::uint32_t layers) {
  PolygonMesh scalp;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const int n = static_cast<int>(sides);
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [found, isNew] =
        known.emplace(at, static_cast<std::uint32_t>(scalp.positions.size()));
    if (isNew) scalp.positions.emplace_back(glm::vec3(at[0], at[1], at[2]) / static_cast<float>(n));
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {-n, n})
      for (int i = -n; i < n; i += 2)
        for (int j = -n; j < n; j += 2) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[axis] = side, at[(axis + 1) % 3] = i + u, at[(axis + 2) % 3] = j + v;
            return vertex(at);
          };
          std::array<std::uint32_t, 4> face = {corner(0, 0), corner(2, 0), corner(2, 2),
                                               corner(0, 2)};
          if (side < 0) std::reverse(face.begin(), face.end());
          scalp.corners.insert(scalp.corners.end(), face.begin(), face.end());
          scalp.firstCorner.push_back(static_cast<std::uint32_t>(scalp.corners.size()));
        }
  return moved(stack(scalp, layers), [&](glm::vec3, std::uint32_t k, std::uint32_t v) {
    return (0.1f + 0.04f * static_cast<float>(k)) * glm::normalize(scalp.positions[v]);
  });
}

/// What laws of interior placement are tried on: each has one minimum.
struct Sample {
  const char* name;
  HairMesh mesh;
};

inline std::vector<Sample> samples() {
  HairMesh pins = waved(stack(gridScalp(6, 5), 6)), closed = waved(ball(4, 3));
  for (const std::uint32_t v : {9u, 17u, 23u}) {
    pins.layers[3].pinned[v] = 1;
    pins.layers[3].positions[v].x += 0.02f;
  }
  for (const std::size_t k : {1u, 2u}) closed.layers[k].pinned[5] = 1;
  const HairMesh fork = forked(
      stack(gridScalp(6, 4), 6), 3, [](glm::vec3 p) { return std::abs(p.x - 0.06f) < 1e-4f; },
      [](std::size_t j) { return j % 6 >= 3; });
  return {{"AGrid", waved(stack(gridScalp(9, 9), 9))},
          {"APlateOfTrianglesAndQuads", waved(stack(plate(9), 5))},
          {"AFork", waved(fork)},
          {"AnEarlyEnd", waved(ending(stack(gridScalp(6, 6), 5), 14, 3))},
          {"AMeshWithPins", pins},
          {"ABallWithPins", closed},
          {"AShakenMesh", shaken(waved(stack(gridScalp(7, 6), 7)), 0.02f)}};
}

inline void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.name;
}
inline std::string nameOf(const testing::TestParamInfo<Sample>& sample) {
  return sample.param.name;
}

}  // namespace hair::test

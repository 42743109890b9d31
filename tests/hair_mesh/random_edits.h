#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/hair_mesh/operations.h>

// Operations drawn at random, with arguments that mostly make sense.
namespace hair::test {

enum class Operation : std::uint8_t {
  Extrude,
  Delete,
  InsertLayer,
  RemoveLayer,
  SeparateEdges,
  SeparateVertices,
  WeldVertices,
  WeldEdges,
  DivideFace,
  DivideEdge,
  Subdivide,
};
inline constexpr std::size_t kOperationCount = 11;
inline constexpr std::array<const char*, kOperationCount> kOperationNames = {
    "extrude",           "delete",        "insert layer", "remove layer", "separate edges",
    "separate vertices", "weld vertices", "weld edges",   "divide face",  "divide edge",
    "subdivide"};

/// The same numbers in every run, whatever the standard library.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : seed_(seed) {}
  std::uint32_t word() { return hashWord(count_++ ^ hashWord(seed_)); }
  std::uint32_t below(std::size_t end) {
    return end == 0 ? 0 : word() % static_cast<std::uint32_t>(end);
  }
  bool oneIn(std::uint32_t n) { return below(n) == 0; }
  float between(float a, float b) { return a + (b - a) * float(word() >> 8) * 0x1p-24f; }

 private:
  std::uint32_t seed_, count_ = 0;
};

/// Some of the bundles, each once: one, or those with corners near one, or all.
inline std::vector<std::uint32_t> drawBundles(const HairMesh& mesh, Draw& draw) {
  std::vector<std::uint32_t> bundles;
  const std::uint32_t share = 1 + draw.below(4);
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    if (draw.below(4) < share) bundles.push_back(j);
  if (draw.oneIn(3)) bundles.assign(1, draw.below(mesh.bundleCount()));
  return bundles;
}

/// A layer from 1 on, if there is one, and a bundle with a face there.
inline std::pair<std::size_t, std::uint32_t> drawFace(const HairMesh& mesh, Draw& draw) {
  std::uint32_t j = draw.below(mesh.bundleCount());
  for (std::size_t tries = 0; tries < mesh.bundleCount() && mesh.lastLayer[j] == 0; ++tries)
    j = (j + 1) % static_cast<std::uint32_t>(mesh.bundleCount());
  return {1 + draw.below(mesh.lastLayer[j]), j};
}

inline HairMeshEdge sideOf(const HairMesh& mesh, std::size_t layer, std::uint32_t corner) {
  const auto j = std::upper_bound(mesh.firstCorner.begin(), mesh.firstCorner.end(), corner) -
                 mesh.firstCorner.begin() - 1;
  return {mesh.layers[layer].corners[corner],
          mesh.layers[layer].corners[mesh.nextCorner(static_cast<std::size_t>(j), corner)]};
}

inline std::uint32_t drawCorner(const HairMesh& mesh, std::uint32_t bundle, Draw& draw) {
  return mesh.firstCorner[bundle] + draw.below(mesh.sides(bundle));
}

/// The other corner of the scalp's edge that starts at `corner`, if it has two faces.
inline std::optional<std::uint32_t> acrossScalp(const HairMesh& mesh, std::uint32_t corner) {
  const HairMeshEdge side = sideOf(mesh, 0, corner);
  for (std::uint32_t c = 0; c < mesh.cornerCount(); ++c)
    if (const HairMeshEdge other = sideOf(mesh, 0, c); other.a == side.b && other.b == side.a)
      return c;
  return {};
}

/// A corner of a layer from 1 on, if there is one, for which suits(layer, corner), or just any.
template <class Suits>
std::pair<std::size_t, std::uint32_t> drawCornerThat(const HairMesh& mesh, Draw& draw,
                                                     Suits suits) {
  std::pair<std::size_t, std::uint32_t> at;
  for (int tries = 0; tries < 40; ++tries) {
    const auto [layer, bundle] = drawFace(mesh, draw);
    at = {std::min(layer, mesh.layerCount() - 1), drawCorner(mesh, bundle, draw)};
    if (suits(at.first, at.second)) break;
  }
  return at;
}

/// Applies the operation, with arguments drawn for it. Throws Error where it is refused.
inline void apply(Operation operation, Draw& draw, HairMesh& mesh) {
  const bool nonsense = draw.oneIn(10);  // in one argument
  auto [layer, bundle] = drawFace(mesh, draw);
  if (nonsense) bundle += draw.below(2 * mesh.bundleCount());
  const auto across = [&](std::size_t k, std::uint32_t c) {
    const auto other = acrossScalp(mesh, c);
    return other && mesh.layers[k].corners[*other] != kNoVertex ? other : std::nullopt;
  };
  const auto isCut = [&](std::size_t k, std::uint32_t c) {
    const auto other = across(k, c);
    if (!other) return false;
    const HairMeshEdge x = sideOf(mesh, k, c), y = sideOf(mesh, k, *other);
    return x.a != y.b || x.b != y.a;
  };
  switch (operation) {
    case Operation::Extrude: {
      auto bundles = drawBundles(mesh, draw);
      if (nonsense) bundles.push_back(bundle);
      return extrudeFaces(bundles, draw.oneIn(2) ? 0.01f : draw.between(-0.01f, 0.03f), mesh);
    }
    case Operation::Delete: {
      auto bundles = drawBundles(mesh, draw);
      if (nonsense) bundles.push_back(bundle);
      return deleteFaces(bundles, mesh);
    }
    case Operation::InsertLayer:
      return insertLayer(layer, bundle, mesh);
    case Operation::RemoveLayer:
      return removeLayer(layer, bundle, mesh);
    case Operation::SeparateEdges: {
      const auto [k, c] = drawCornerThat(mesh, draw, [&](std::size_t l, std::uint32_t at) {
        return across(l, at).has_value() && !isCut(l, at);
      });
      std::vector<HairMeshEdge> edges = {sideOf(mesh, k, c)};
      // On around its end, where there is another that is joined; inside, one edge parts nothing.
      for (std::uint32_t d = 0; d < mesh.cornerCount() && edges.size() < 2; ++d)
        if (mesh.layers[k].corners[d] == edges[0].b && across(k, d) && !isCut(k, d) &&
            sideOf(mesh, k, d).b != edges[0].a && !draw.oneIn(3))
          edges.push_back(sideOf(mesh, k, d));
      return separateEdges(nonsense ? k + 1 : k, edges, mesh);
    }
    case Operation::SeparateVertices: {
      const auto [k, c] = drawCornerThat(mesh, draw, [&](std::size_t l, std::uint32_t at) {
        return across(l, at) && !isCut(l, at);
      });
      return separateVertices(nonsense ? k + 1 : k, {&mesh.layers[k].corners[c], 1}, mesh);
    }
    case Operation::WeldVertices: {
      // The open end of a cut that ends at the other.
      const auto [k, c] = drawCornerThat(mesh, draw, [&](std::size_t l, std::uint32_t at) {
        if (!isCut(l, at)) return false;
        const HairMeshEdge x = sideOf(mesh, l, at), y = sideOf(mesh, l, *across(l, at));
        return x.a == y.b || x.b == y.a;
      });
      const HairMeshEdge x = sideOf(mesh, k, c);
      const auto other = across(k, c);
      const HairMeshEdge y = other ? sideOf(mesh, k, *other) : x;
      const bool start = nonsense ? draw.oneIn(2) : x.a != y.b;
      return weldVertices(k, start ? x.a : x.b, start ? y.b : y.a, mesh);
    }
    case Operation::WeldEdges: {
      const auto [k, c] = drawCornerThat(mesh, draw, isCut);
      const auto other = across(k, c);
      return weldEdges(k, sideOf(mesh, k, c), sideOf(mesh, k, other ? *other : c), mesh);
    }
    case Operation::DivideFace:
      if (const std::uint32_t a = draw.below(5); !nonsense)
        divideFace(bundle, a % mesh.sides(bundle), (a + 2) % mesh.sides(bundle), mesh);
      else
        divideFace(bundle, a, draw.below(5), mesh);
      return;
    case Operation::DivideEdge:
      return divideEdge(bundle, draw.below(4), mesh);
    case Operation::Subdivide:
      subdivide(draw.oneIn(2) ? Subdivision::CatmullClark : Subdivision::Loop, draw.oneIn(2), mesh);
      return;
  }
}

/// Moves and pins some vertices above the scalp: what a user does between operations.
inline void moveSome(Draw& draw, HairMesh& mesh) {
  for (std::size_t k = 1; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v) {
      if (!draw.oneIn(8)) continue;
      mesh.layers[k].pinned[v] = draw.oneIn(2);
      for (int axis = 0; axis < 3; ++axis)
        mesh.layers[k].positions[v][axis] += draw.between(-0.003f, 0.003f);
    }
}

}  // namespace hair::test

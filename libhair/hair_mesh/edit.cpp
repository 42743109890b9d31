#include <algorithm>
#include <array>
#include <numeric>

#include <libhair/hair_mesh/edit-inl.h>

namespace hair {

CornerTable::CornerTable(const HairMesh& mesh)
    : bundle(mesh.cornerCount()), next(mesh.cornerCount()) {
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
      bundle[c] = j;
      next[c] = mesh.nextCorner(j, c);
    }
}

std::vector<LayerEdge> edgesOf(const CornerTable& table, std::span<const std::uint32_t> vertices) {
  std::vector<LayerEdge> sides;
  for (std::uint32_t c = 0; c < vertices.size(); ++c) {
    if (vertices[c] == kNoVertex) continue;
    const auto [a, b] = std::minmax(vertices[c], vertices[table.next[c]]);
    sides.push_back({a, b, c});
  }
  std::sort(sides.begin(), sides.end(), [](const LayerEdge& x, const LayerEdge& y) {
    return std::array{x.a, x.b, x.corner} < std::array{y.a, y.b, y.corner};
  });
  std::vector<LayerEdge> edges;
  for (const LayerEdge& side : sides) {
    LayerEdge* last = edges.empty() ? nullptr : &edges.back();
    if (last && last->a == side.a && last->b == side.b && !last->isInner())
      last->other = side.corner;
    else
      edges.push_back(side);
  }
  return edges;
}

const LayerEdge* findEdge(std::span<const LayerEdge> edges, std::uint32_t a, std::uint32_t b) {
  const std::array<std::uint32_t, 2> wanted = {std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(
      edges.begin(), edges.end(), wanted,
      [](const LayerEdge& edge, const auto& ends) { return std::array{edge.a, edge.b} < ends; });
  return found != edges.end() && std::array{found->a, found->b} == wanted ? &*found : nullptr;
}

JoinedSets::JoinedSets(std::size_t size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t JoinedSets::find(std::uint32_t x) {
  while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
  return x;
}

void JoinedSets::join(std::uint32_t x, std::uint32_t y) {
  const auto [least, most] = std::minmax({find(x), find(y)});
  parent_[most] = least;
}

std::vector<std::uint32_t> fansOf(const CornerTable& table, std::span<const LayerEdge> edges,
                                  std::span<const std::uint32_t> vertices) {
  JoinedSets fans(vertices.size());
  for (const LayerEdge& edge : edges) {
    if (!edge.isInner()) continue;
    fans.join(edge.corner, table.next[edge.other]);
    fans.join(edge.other, table.next[edge.corner]);
  }
  std::vector<std::uint32_t> least(vertices.size(), kNoVertex);
  for (std::uint32_t c = 0; c < vertices.size(); ++c)
    if (vertices[c] != kNoVertex) least[c] = fans.find(c);
  return least;
}

void rejoin(std::size_t k, HairMesh& mesh, std::span<const std::uint32_t> parts) {
  HairMesh::Layer& layer = mesh.layers[k];
  const std::size_t corners = mesh.cornerCount();
  const std::span<const std::uint32_t> lower =
      k == 0 ? std::span<const std::uint32_t>() : std::span(mesh.layers[k - 1].corners);

  // Corners that may be one vertex get one name, the least of them.
  struct Key {
    std::array<std::uint32_t, 3> what;  // vertex, part, vertex below
    std::uint32_t corner;
  };
  std::vector<Key> keys;
  for (std::uint32_t c = 0; c < corners; ++c)
    if (layer.corners[c] != kNoVertex)
      keys.push_back({{layer.corners[c], parts.empty() ? 0 : parts[c], k == 0 ? 0 : lower[c]}, c});
  std::sort(keys.begin(), keys.end(), [](const Key& x, const Key& y) {
    return x.what != y.what ? x.what < y.what : x.corner < y.corner;
  });
  std::vector<std::uint32_t> names(corners, kNoVertex);
  for (std::size_t i = 0; i < keys.size(); ++i)
    names[keys[i].corner] =
        i > 0 && keys[i].what == keys[i - 1].what ? names[keys[i - 1].corner] : keys[i].corner;
  const CornerTable table(mesh);
  const std::vector<std::uint32_t> fans = fansOf(table, edgesOf(table, names), names);

  // The vertices, each by its least corner: first those that keep their numbers.
  std::vector<std::uint32_t> keeper(layer.vertexCount(), kNoVertex);
  for (std::uint32_t c = 0; c < corners; ++c)
    if (fans[c] == c && keeper[layer.corners[c]] == kNoVertex) keeper[layer.corners[c]] = c;
  std::vector<std::uint32_t> order;
  for (const std::uint32_t c : keeper)
    if (c != kNoVertex) order.push_back(c);
  for (std::uint32_t c = 0; c < corners; ++c)
    if (fans[c] == c && keeper[layer.corners[c]] != c) order.push_back(c);

  HairMesh::Layer joined;
  std::vector<std::uint32_t> number(corners);
  for (const std::uint32_t c : order) {
    number[c] = static_cast<std::uint32_t>(joined.vertexCount());
    joined.positions.push_back(layer.positions[layer.corners[c]]);
    joined.pinned.push_back(layer.pinned[layer.corners[c]]);
    if (k > 0) joined.below.push_back(lower[c]);
  }
  joined.corners.assign(corners, kNoVertex);
  for (std::uint32_t c = 0; c < corners; ++c)
    if (fans[c] != kNoVertex) joined.corners[c] = number[fans[c]];
  layer = std::move(joined);
}

void rejoinFrom(std::size_t layer, HairMesh& mesh) {
  for (std::size_t k = layer; k < mesh.layerCount(); ++k) rejoin(k, mesh);
  while (!mesh.layers.empty() && mesh.layers.back().positions.empty()) mesh.layers.pop_back();
}

void addEmptyLayer(HairMesh& mesh) {
  mesh.layers.emplace_back().corners.assign(mesh.cornerCount(), kNoVertex);
}

void requireBundle(const HairMesh& mesh, std::uint32_t bundle) {
  require(bundle < mesh.bundleCount(), "bundle ", bundle, " does not exist: there are ",
          mesh.bundleCount(), ", numbered from 0");
}

void requireBundles(const HairMesh& mesh, std::span<const std::uint32_t> bundles) {
  require(!bundles.empty(), "no bundles are named");
  std::vector<std::uint8_t> named(mesh.bundleCount(), 0);
  for (const std::uint32_t j : bundles) {
    requireBundle(mesh, j);
    require(!named[j], "bundle ", j, " is named twice");
    named[j] = 1;
  }
}

void requireLayer(const HairMesh& mesh, std::size_t layer) {
  require(layer > 0, "layer 0 is the scalp's: name a layer from 1 on");
  require(layer < mesh.layerCount(), "layer ", layer, " does not exist: the top layer is ",
          mesh.layerCount() - 1);
}

void requireVertex(const HairMesh& mesh, std::size_t layer, std::uint32_t vertex) {
  require(vertex < mesh.layers[layer].vertexCount(), "layer ", layer, ": vertex ", vertex,
          " does not exist: there are ", mesh.layers[layer].vertexCount(), ", numbered from 0");
}

}  // namespace hair

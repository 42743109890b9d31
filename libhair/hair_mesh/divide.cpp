#include <utility>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

// Corners in a new order: `source` gives the old number of each, kNoVertex for a new corner.
void layOutCorners(std::vector<std::uint32_t> firstCorner, std::span<const std::uint32_t> source,
                   HairMesh& mesh) {
  for (HairMesh::Layer& layer : mesh.layers) {
    std::vector<std::uint32_t> corners;
    corners.reserve(source.size());
    for (const std::uint32_t c : source)
      corners.push_back(c == kNoVertex ? kNoVertex : layer.corners[c]);
    layer.corners = std::move(corners);
  }
  mesh.firstCorner = std::move(firstCorner);
}

void requireCorner(const HairMesh& mesh, std::uint32_t bundle, std::uint32_t corner) {
  requireBundle(mesh, bundle);
  require(corner < mesh.sides(bundle), "bundle ", bundle, " has corners 0 to ",
          mesh.sides(bundle) - 1, ", not ", corner);
}

}  // namespace

std::uint32_t divideFace(std::uint32_t bundle, std::uint32_t cornerA, std::uint32_t cornerB,
                         HairMesh& mesh) {
  const auto number = static_cast<std::uint32_t>(mesh.bundleCount());
  editCopy(mesh, [&](HairMesh& m) {
    requireCorner(m, bundle, cornerA);
    requireCorner(m, bundle, cornerB);
    const std::uint32_t sides = m.sides(bundle);
    const std::uint32_t along = (cornerB + sides - cornerA) % sides;  // edges from A to B
    require(along > 1 && along + 1 < sides, "bundle ", bundle, ": corners ", cornerA, " and ",
            cornerB, " are the same or neighbours, so one part would have no area");
    std::vector<std::uint32_t> firstCorner = {0}, source;
    const auto addPart = [&](std::uint32_t from, std::uint32_t edges) {
      for (std::uint32_t i = 0; i <= edges; ++i)
        source.push_back(m.firstCorner[bundle] + (from + i) % sides);
      firstCorner.push_back(static_cast<std::uint32_t>(source.size()));
    };
    for (std::uint32_t j = 0; j < number; ++j) {
      if (j == bundle) {
        addPart(cornerA, along);
        continue;
      }
      for (std::uint32_t c = m.firstCorner[j]; c < m.firstCorner[j + 1]; ++c) source.push_back(c);
      firstCorner.push_back(static_cast<std::uint32_t>(source.size()));
    }
    addPart(cornerB, sides - along);
    m.lastLayer.push_back(m.lastLayer[bundle]);
    layOutCorners(std::move(firstCorner), source, m);
  });
  return number;
}

void divideEdge(std::uint32_t bundle, std::uint32_t corner, HairMesh& mesh) {
  editCopy(mesh, [&](HairMesh& m) {
    requireCorner(m, bundle, corner);
    const CornerTable table(m);
    const std::uint32_t start = m.firstCorner[bundle] + corner;
    const std::vector<std::uint32_t>& root = m.layers[0].corners;
    const auto edges = edgesOf(table, root);
    const LayerEdge& edge = *findEdge(edges, root[start], root[table.next[start]]);
    const std::uint32_t other = edge.corner == start ? edge.other : edge.corner;

    std::vector<std::uint32_t> firstCorner = {0}, source;
    std::uint32_t middle = kNoVertex, otherMiddle = kNoVertex;  // the new corners
    for (std::uint32_t j = 0; j < m.bundleCount(); ++j) {
      for (std::uint32_t c = m.firstCorner[j]; c < m.firstCorner[j + 1]; ++c) {
        source.push_back(c);
        if (c != start && c != other) continue;
        (c == start ? middle : otherMiddle) = static_cast<std::uint32_t>(source.size());
        source.push_back(kNoVertex);
      }
      firstCorner.push_back(static_cast<std::uint32_t>(source.size()));
    }
    const std::vector<HairMesh::Layer> old = m.layers;
    layOutCorners(std::move(firstCorner), source, m);

    for (std::size_t k = 0; k < m.layerCount(); ++k) {
      const std::vector<std::uint32_t>& was = old[k].corners;
      HairMesh::Layer& layer = m.layers[k];
      const auto addMiddle = [&](std::uint32_t c) {
        layer.positions.push_back(
            0.5f * (old[k].positions[was[c]] + old[k].positions[was[table.next[c]]]));
        layer.pinned.push_back(0);
        return static_cast<std::uint32_t>(layer.positions.size() - 1);
      };
      const bool here = was[start] != kNoVertex;
      const bool beside = other != kNoVertex && was[other] != kNoVertex;
      const bool joined = here && beside && was[start] == was[table.next[other]] &&
                          was[other] == was[table.next[start]];
      if (here) layer.corners[middle] = addMiddle(start);
      if (beside) layer.corners[otherMiddle] = joined ? layer.corners[middle] : addMiddle(other);
    }
    rejoinFrom(0, m);
  });
}

}  // namespace hair

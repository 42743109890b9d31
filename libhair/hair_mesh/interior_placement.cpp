#include <libhair/hair_mesh/interior_placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/hair_mesh/surface.h>

namespace hair {

namespace {

std::uint64_t hashTopology(const HairMesh& mesh) {
  StateHash hash;
  const auto add = [&](const auto& values) { hash.add(std::span(values.data(), values.size())); };
  add(mesh.firstCorner);
  add(mesh.lastLayer);
  for (const HairMesh::Layer& layer : mesh.layers) {
    add(layer.corners);
    add(layer.pinned);
    const std::size_t count = layer.vertexCount();
    hash.add(std::span<const std::size_t>(&count, 1));
  }
  return hash.value();
}

// Of each layer, the number of its first vertex in the mesh.
std::vector<std::uint32_t> firstOfLayer(const HairMesh& mesh) {
  std::vector<std::uint32_t> first = {0};
  for (const HairMesh::Layer& layer : mesh.layers)
    first.push_back(first.back() + static_cast<std::uint32_t>(layer.vertexCount()));
  return first;
}

// V_i^k, V_{i+1}^k, V_i^{k+1}, V_{i+1}^{k+1}, numbered through the mesh, and how they count.
using SideQuad = std::array<std::uint32_t, 4>;
constexpr std::array<float, 4> kSigns = {-1, 1, 1, -1};

template <class Visit>
void forEachSideQuad(const HairMesh& mesh, Visit&& visit) {
  const std::vector<std::uint32_t> first = firstOfLayer(mesh);
  for (std::size_t k = 0; k + 1 < mesh.layerCount(); ++k) {
    const auto& low = mesh.layers[k].corners;
    const auto& high = mesh.layers[k + 1].corners;
    for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
      if (mesh.lastLayer[j] <= k) continue;
      for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
        const std::uint32_t next = mesh.nextCorner(j, c);
        visit(SideQuad{first[k] + low[c], first[k] + low[next], first[k + 1] + high[c],
                       first[k + 1] + high[next]});
      }
    }
  }
}

bool isFinite(glm::vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double sum(glm::dvec3 v) {
  return v.x + v.y + v.z;
}

// 0 where there is nothing left to divide: a coordinate that needs no move.
glm::dvec3 ratio(glm::dvec3 a, glm::dvec3 b) {
  return {b.x > 0 ? a.x / b.x : 0, b.y > 0 ? a.y / b.y : 0, b.z > 0 ? a.z / b.z : 0};
}

}  // namespace

InteriorPlacement::InteriorPlacement(const HairMesh& mesh) {
  validate(mesh, "placeInterior");
  topology_ = hashTopology(mesh);
  numberVertices(mesh);
  assemble(mesh);
  findIslands(mesh);
  for (auto* vectors : {&move_, &residual_, &direction_, &change_}) vectors->resize(freeCount());
}

void InteriorPlacement::numberVertices(const HairMesh& mesh) {
  std::vector<std::uint8_t> held;
  const auto exterior = exteriorVertices(mesh);
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
      held.push_back(exterior[k][v] | mesh.layers[k].pinned[v]);
  const auto freeCount = static_cast<std::uint32_t>(std::count(held.begin(), held.end(), 0));
  std::array<std::uint32_t, 2> next = {0, freeCount};
  for (const std::uint8_t h : held) number_.push_back(next[h]++);
  places_.resize(number_.size());
  inverse_.resize(freeCount);
}

// The matrix of E / 2, its rows of free vertices: each quad adds the products of its four signs.
void InteriorPlacement::assemble(const HairMesh& mesh) {
  struct Entry {
    std::uint32_t column;
    float weight;
  };
  const std::size_t rows = freeCount();
  std::vector<std::size_t> firstEntry(rows + 1, 0);
  const auto forEachOfRows = [&](auto&& visit) {
    forEachSideQuad(mesh, [&](const SideQuad& quad) {
      for (std::size_t a = 0; a < 4; ++a)
        if (number_[quad[a]] < rows) visit(number_[quad[a]], quad, a);
    });
  };
  forEachOfRows([&](std::uint32_t row, const SideQuad&, std::size_t) { firstEntry[row + 1] += 4; });
  std::partial_sum(firstEntry.begin(), firstEntry.end(), firstEntry.begin());
  std::vector<Entry> entries(firstEntry.back());
  std::vector<std::size_t> next(firstEntry.begin(), firstEntry.end() - 1);
  forEachOfRows([&](std::uint32_t row, const SideQuad& quad, std::size_t a) {
    for (std::size_t b = 0; b < 4; ++b)
      entries[next[row]++] = {number_[quad[b]], kSigns[a] * kSigns[b]};
  });

  // One entry a column. Free vertices have the smaller numbers, so they come first.
  first_ = {0};
  for (std::size_t row = 0; row < rows; ++row) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(firstEntry[row]);
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(firstEntry[row + 1]);
    std::sort(begin, end, [](Entry a, Entry b) { return a.column < b.column; });
    double diagonal = 0;
    for (auto entry = begin; entry != end; ++entry) {
      if (columns_.size() > first_.back() && columns_.back() == entry->column) {
        weights_.back() += entry->weight;
      } else {
        columns_.push_back(entry->column);
        weights_.push_back(entry->weight);
      }
      if (entry->column == row) diagonal += entry->weight;
    }
    diagonalSum_ += diagonal;
    inverse_[row] = 1 / diagonal;
    const auto from = columns_.begin() + first_.back();
    firstHeld_.push_back(static_cast<std::uint32_t>(
        std::lower_bound(from, columns_.end(), static_cast<std::uint32_t>(rows)) -
        columns_.begin()));
    first_.push_back(static_cast<std::uint32_t>(columns_.size()));
  }
}

// E depends only on differences, along a layer's edges, of the displacement between layers. So it
// is invariant under translations of each connected part of each layer. A part with a fixed vertex
// cannot translate.
void InteriorPlacement::findIslands(const HairMesh& mesh) {
  std::vector<std::uint32_t> parent(number_.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto rootOf = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    a = rootOf(a), b = rootOf(b);
    parent[std::max(a, b)] = std::min(a, b);
  };
  forEachSideQuad(mesh, [&](const SideQuad& quad) { join(quad[2], quad[3]); });
  std::vector<std::uint8_t> held(number_.size(), 0);
  for (std::uint32_t v = 0; v < number_.size(); ++v)
    if (number_[v] >= freeCount()) held[rootOf(v)] = 1;
  std::vector<std::uint32_t> islandOf(number_.size(), kNoVertex);
  for (std::uint32_t v = 0; v < number_.size(); ++v) {
    const std::uint32_t root = rootOf(v);
    if (held[root]) continue;
    if (islandOf[root] == kNoVertex) {
      islandOf[root] = static_cast<std::uint32_t>(islands_.size());
      islands_.emplace_back();
    }
    islands_[islandOf[root]].push_back(number_[v]);
  }
}

// Fills places_; the diagonal of the box around held vertices, or if that is a point around all.
double InteriorPlacement::gather(const HairMesh& mesh) {
  constexpr double kFar = std::numeric_limits<double>::max();
  glm::dvec3 low(kFar), high(-kFar), lowOfAll(kFar), highOfAll(-kFar);
  std::size_t at = 0;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v) {
      require(isFinite(mesh.layers[k].positions[v]), "placeInterior: layer ", k, ", vertex ", v,
              " is at no finite place");
      const glm::dvec3 place = mesh.layers[k].positions[v];
      const std::uint32_t number = number_[at++];
      places_[number] = place;
      lowOfAll = glm::min(lowOfAll, place), highOfAll = glm::max(highOfAll, place);
      if (number >= freeCount()) low = glm::min(low, place), high = glm::max(high, place);
    }
  const double size = glm::distance(low, high);
  return size > 0 ? size : glm::distance(lowOfAll, highOfAll);
}

// Preconditioned conjugate gradients (Shewchuk 1994, B3), x, y and z side by side, for the moves
// that bring the gradient of E to zero.
PlacementResult InteriorPlacement::solve(double size, const PlacementSettings& settings) {
  const std::size_t rows = freeCount();
  const std::uint32_t most = settings.maxIterations > 0
                                 ? settings.maxIterations
                                 : static_cast<std::uint32_t>(std::min<std::size_t>(rows, 10'000));

  // Weights are whole numbers and places are floats: these sums are exact.
  glm::dvec3 alike(0);
  for (std::size_t r = 0; r < rows; ++r) {
    glm::dvec3 gradient(0);
    for (std::uint32_t e = first_[r]; e < first_[r + 1]; ++e)
      gradient += static_cast<double>(weights_[e]) * places_[columns_[e]];
    move_[r] = glm::dvec3(0);
    residual_[r] = -gradient;
    direction_[r] = inverse_[r] * residual_[r];
    alike += residual_[r] * direction_[r];
  }
  PlacementResult result;
  const auto left = [&] {
    return std::sqrt(sum(alike) / diagonalSum_);
  };  // metres, root mean square
  while (left() > settings.tolerance * size && result.iterations < most) {
    glm::dvec3 curvature(0);
    for (std::size_t r = 0; r < rows; ++r) {
      glm::dvec3 product(0);
      for (std::uint32_t e = first_[r]; e < firstHeld_[r]; ++e)
        product += static_cast<double>(weights_[e]) * direction_[columns_[e]];
      change_[r] = product;
      curvature += direction_[r] * product;
    }
    const glm::dvec3 step = ratio(alike, curvature), before = alike;
    alike = glm::dvec3(0);
    for (std::size_t r = 0; r < rows; ++r) {
      move_[r] += step * direction_[r];
      residual_[r] -= step * change_[r];
      alike += residual_[r] * (inverse_[r] * residual_[r]);
    }
    const glm::dvec3 keep = ratio(alike, before);
    for (std::size_t r = 0; r < rows; ++r)
      direction_[r] = inverse_[r] * residual_[r] + keep * direction_[r];
    ++result.iterations;
  }
  result.residual = size > 0 ? static_cast<float>(left() / size) : 0;
  result.converged = left() <= settings.tolerance * size;
  return result;
}

PlacementResult InteriorPlacement::place(HairMesh& mesh, const PlacementSettings& settings) {
  require(settings.tolerance > 0 && std::isfinite(settings.tolerance),
          "placeInterior: tolerance = ", settings.tolerance, " is not above 0");
  require(hashTopology(mesh) == topology_,
          "placeInterior: topology or pins have changed; make an InteriorPlacement of this mesh");
  const double size = gather(mesh);
  if (freeCount() == 0) return {};
  PlacementResult result = solve(size, settings);
  result.unique = islands_.empty();
  for (const auto& island : islands_) {
    glm::dvec3 mean(0);
    for (const std::uint32_t r : island) mean += move_[r] / static_cast<double>(island.size());
    for (const std::uint32_t r : island) move_[r] -= mean;
  }
  std::size_t at = 0;
  for (HairMesh::Layer& layer : mesh.layers)
    for (glm::vec3& place : layer.positions) {
      const std::uint32_t number = number_[at++];
      if (number < freeCount()) place = glm::vec3(places_[number] + move_[number]);
    }
  return result;
}

PlacementResult placeInterior(HairMesh& mesh, const PlacementSettings& settings) {
  return InteriorPlacement(mesh).place(mesh, settings);
}

}  // namespace hair

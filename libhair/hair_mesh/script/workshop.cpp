#include <libhair/hair_mesh/script/workshop.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/interior_placement.h>

namespace hair {

BundleSet Workshop::selected(std::string_view name) const {
  require(mesh().bundleCount() > 0, "there is no scalp yet: `scalp head RINGS SECTORS`");
  if (name == "all") return BundleSet(mesh().bundleCount(), 1);
  const auto found = selections.find(name);
  require(found != selections.end(), "there is no selection '", name, "'; `select ", name,
          " ...` makes one");
  return found->second;
}

std::vector<std::uint32_t> Workshop::bundles(std::string_view name) const {
  const BundleSet set = selected(name);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t j = 0; j < set.size(); ++j)
    if (set[j]) numbers.push_back(j);
  require(!numbers.empty(), "no bundle is in '", name, "'");
  return numbers;
}

void Workshop::requireRoom(std::size_t corners, std::size_t layers) const {
  const std::size_t used = usedCorners(mesh()) + corners;
  require(used <= limits.corners, "the mesh would have ", used, " corners of faces, at most ",
          limits.corners, "; fewer layers or bundles do");
  // Each layer has an array of all corners, in use or not.
  const std::size_t stored = (mesh().layerCount() + layers) * mesh().cornerCount();
  require(stored <= 4 * limits.corners, "the mesh would have ", mesh().layerCount() + layers,
          " layers for ", mesh().cornerCount(),
          " corners of the scalp, most of them empty; at most ", 4 * limits.corners, " together");
}

void Workshop::spend() {
  work += usedCorners(mesh());
  require(work <= limits.work, "the script is too much work: ", work,
          " corners of faces in all its passes over the mesh, at most ", limits.work);
}

void Workshop::renumber(std::span<const std::uint32_t> from) {
  const auto follow = [&](auto& ofBundles) {
    if (ofBundles.empty()) return;
    auto now = ofBundles;
    now.resize(from.size());
    for (std::size_t b = 0; b < from.size(); ++b) now[b] = ofBundles[from[b]];
    ofBundles = std::move(now);
  };
  for (auto& [name, set] : selections) follow(set);
  follow(style.tied);
  follow(ring);
  follow(sector);
}

void Workshop::place() {
  // An iteration is a pass over the mesh too.
  const std::size_t corners = std::max<std::size_t>(usedCorners(mesh()), 1);
  const std::size_t left = limits.work > work ? limits.work - work : 0;
  PlacementSettings settings;
  settings.maxIterations =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(left / corners, 1, 10'000));
  work += placeInterior(mesh(), settings).iterations * corners;
}

void Workshop::afterGeometry() {
  if (autoPlace) place();
}

std::size_t usedCorners(const HairMesh& mesh) {
  std::size_t corners = 0;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    corners += std::size_t{mesh.sides(j)} * (mesh.lastLayer[j] + 1);
  return corners;
}

glm::vec3 outwards(const std::function<float(glm::vec3)>& distance, glm::vec3 p) {
  constexpr float kStep = 2e-4f;
  glm::vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 step(0);
    step[axis] = kStep;
    gradient[axis] = distance(p + step) - distance(p - step);
  }
  const float length = glm::length(gradient);
  return length > 1e-9f ? gradient / length : glm::vec3(0, 1, 0);
}

Target readTarget(ScriptWords& words) {
  Target target;
  target.selection = words.name("a selection");
  if (words.take("at")) {
    if (words.take("tip")) {
      target.tip = true;
    } else {
      std::tie(target.lowest, target.highest) = words.range("layers", 1, 100'000);
    }
  }
  target.ramp = words.take("ramp");
  return target;
}

std::vector<TargetVertex> verticesOf(const Workshop& workshop, const Target& target) {
  const HairMesh& mesh = workshop.mesh();
  std::vector<std::vector<float>> weight(mesh.layerCount());
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    weight[k].assign(mesh.layers[k].vertexCount(), 0);
  for (const std::uint32_t j : workshop.bundles(target.selection)) {
    const std::uint32_t top = std::min(target.highest, mesh.lastLayer[j]);
    const std::uint32_t from = std::max(target.tip ? top : target.lowest, 1u);
    for (std::uint32_t k = from; k <= top; ++k) {
      const float share = target.ramp ? static_cast<float>(k - target.lowest + 1) /
                                            static_cast<float>(top - target.lowest + 1)
                                      : 1;
      for (const std::uint32_t v : mesh.face(k, j)) weight[k][v] = std::max(weight[k][v], share);
    }
  }
  std::vector<TargetVertex> vertices;
  for (std::uint32_t k = 1; k < weight.size(); ++k)
    for (std::uint32_t v = 0; v < weight[k].size(); ++v)
      if (weight[k][v] > 0) vertices.push_back({k, v, weight[k][v]});
  require(!vertices.empty(), "'", target.selection,
          "' has no vertex above the scalp in these layers");
  return vertices;
}

}  // namespace hair

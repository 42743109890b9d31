#include <libhair/model/loaded_head.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/geometry/mesh_parts.h>
#include <libhair/geometry/triangle_distance.h>
#include <libhair/model/head.h>
#include <libhair/model/head_units.h>

namespace hair {

namespace {

// A bust brings shoulders along, which do not move with a head. What is below the neck, and what is
// wider than one, goes; the body's neck reaches up into what stays.
std::size_t dropBust(TriangleMesh& mesh) {
  constexpr float kNeckBottom = -0.06f, kNeckRadius = 0.075f;
  const auto below = [&](std::uint32_t v) {
    const glm::vec3 p = mesh.positions[v];
    return p.y < kNeckBottom || (p.y < 0 && std::hypot(p.x, p.z) > kNeckRadius && p.z < 0.05f);
  };
  return std::erase_if(mesh.triangles,
                       [&](glm::uvec3 t) { return below(t.x) && below(t.y) && below(t.z); });
}

// "0.01 m a unit, +Z up, -Y face"
std::string unitsWords(const ReadOptions& units) {
  return text(units.scale, " m a unit, ", upAxisMeaning(units.up));
}

std::string millimetres(float metres) {
  return text(std::round(metres * 1000), " mm");
}

// As loadedHead's declaration says; nothing is known without roots.
ReadOptions unitsOf(const TriangleMesh& mesh, const HairOnHead& hair, const ReadOptions& read,
                    std::vector<std::string>& notes) {
  const ReadOptions hairs{hair.read.scale > 0 ? hair.read.scale : 1,
                          hair.read.up == UpAxis::AsFile ? UpAxis::Y : hair.read.up};
  const auto filled = [&](const ReadOptions& open) {
    return ReadOptions{read.scale > 0 ? read.scale : open.scale,
                       read.up == UpAxis::AsFile ? open.up : read.up};
  };
  const ReadOptions asHair = filled(hairs), plain = filled({1, UpAxis::Y});
  if (hair.roots.empty()) return asHair;
  const float distance = rootDistance(mesh, hair.roots, asHair);
  if (distance <= kRootsOnHead) return asHair;
  if (rootDistance(mesh, hair.roots, plain) <= kRootsOnHead) {
    notes.push_back(text("head: read as ", unitsWords(plain), ", where it fits the hair"));
    return plain;
  }
  const auto [fitting, fittingDistance] = unitsThatFit(mesh, hair.roots);
  const std::string found = text("head: read as ", unitsWords(asHair), ", its surface is ",
                                 millimetres(distance), " from the hair's roots (median)");
  require(fittingDistance > kRootsOnHead, found, "; it would be ", millimetres(fittingDistance),
          " with --head-scale ", fitting.scale, " --head-up ", wordOf(fitting.up));
  require(distance < 0.1f, found, ", and no unit and axis brings it nearer than ",
          millimetres(fittingDistance),
          ": is it the head of this hair? Without --head the built-in one is scaled to it");
  notes.push_back(found);
  return asHair;
}

// Leaves the parts that hair grows on, and small ones around them. Returns how many parts went.
std::size_t dropSurroundings(TriangleMesh& mesh, std::span<const glm::vec3> roots) {
  constexpr float kLargest = 0.5f;  // of what belongs to a head without carrying hair
  const MeshParts parts = partsOf(mesh);
  if (parts.count < 2 || roots.empty()) return 0;
  std::vector<Bounds> boxes(parts.count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) boxes[parts.of[i]].extend(mesh.positions[mesh.triangles[i][k]]);

  // How many of the roots lie on each part. Each counts for the part it is nearest to, and for all
  // within 3 cm: hair may be rooted on a cap over the head.
  const std::vector<glm::vec3> some = someOf(roots, 64);
  std::vector<std::size_t> carried(parts.count);
  std::vector<float> nearest(parts.count);
  for (const glm::vec3 p : some) {
    std::fill(nearest.begin(), nearest.end(), INFINITY);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3 t = mesh.triangles[i];
      const TriangleCorners corners = {mesh.positions[t.x], mesh.positions[t.y],
                                       mesh.positions[t.z]};
      float& best = nearest[parts.of[i]];
      if (squaredBoxDistance(p, corners) < best) best = std::min(best, squaredDistance(p, corners));
    }
    const float limit = std::max(*std::min_element(nearest.begin(), nearest.end()), 0.03f * 0.03f);
    for (std::size_t part = 0; part < parts.count; ++part) carried[part] += nearest[part] <= limit;
  }
  Bounds head;
  std::vector<bool> kept(parts.count);
  for (std::size_t part = 0; part < parts.count; ++part) {
    kept[part] = carried[part] * 10 >= some.size();
    if (!kept[part]) continue;
    head.extend(boxes[part].lower);
    head.extend(boxes[part].upper);
  }
  for (std::size_t part = 0; part < parts.count; ++part) {
    const glm::vec3 size = boxes[part].size(), apart = glm::max(boxes[part].lower - head.upper,
                                                                head.lower - boxes[part].upper);
    if (std::max({size.x, size.y, size.z}) <= kLargest && std::max({apart.x, apart.y, apart.z}) < 0)
      kept[part] = true;
  }
  std::vector<glm::uvec3> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (kept[parts.of[i]]) triangles.push_back(mesh.triangles[i]);
  mesh.triangles = std::move(triangles);
  return static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
}

}  // namespace

LoadedHead loadedHead(std::vector<TriangleMesh> meshes, const HairOnHead& hair,
                      const ReadOptions& read) {
  require(!meshes.empty(), "head: there is no mesh");
  requireHeadSized(hair.roots);
  LoadedHead loaded;
  dropUnusedVertices(meshes.front());
  loaded.read = unitsOf(meshes.front(), hair, read, loaded.notes);
  for (TriangleMesh& mesh : meshes) {
    convertUnits(mesh.positions, loaded.read.scale, loaded.read.up);
    convertUnits(mesh.normals, 1, loaded.read.up);
  }
  if (const std::size_t dropped = dropSurroundings(meshes.front(), hair.roots); dropped > 0)
    loaded.notes.push_back(text("head: ", dropped, dropped == 1 ? " part" : " parts",
                                " of the mesh left out, away from where hair grows"));
  dropUnusedVertices(meshes.front());
  loaded.headFromHair = placeHead(meshes.front(), hair.roots);
  for (TriangleMesh& mesh : meshes)
    for (glm::vec3& p : mesh.positions) p = loaded.headFromHair.point(p);
  loaded.head.mesh = std::move(meshes.front());
  loaded.others.assign(std::move_iterator(meshes.begin() + 1), std::move_iterator(meshes.end()));
  if (const std::size_t dropped = dropBust(loaded.head.mesh); dropped > 0)
    loaded.notes.push_back(
        text("head: ", dropped, " triangles of shoulders left out; the body has its own"));
  dropUnusedVertices(loaded.head.mesh);
  return loaded;
}

}  // namespace hair

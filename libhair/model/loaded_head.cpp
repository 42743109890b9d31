#include <libhair/model/loaded_head.h>

#include <cmath>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/model/head_fit.h>

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

}  // namespace

LoadedHead loadedHead(std::vector<TriangleMesh> meshes, std::span<const glm::vec3> hairRoots) {
  require(!meshes.empty(), "head: there is no mesh");
  LoadedHead loaded;
  loaded.headFromFile = placeHead(meshes.front(), hairRoots);
  for (TriangleMesh& mesh : meshes)
    for (glm::vec3& p : mesh.positions) p = loaded.headFromFile.point(p);
  loaded.head.mesh = std::move(meshes.front());
  loaded.others.assign(std::move_iterator(meshes.begin() + 1), std::move_iterator(meshes.end()));
  if (const std::size_t dropped = dropBust(loaded.head.mesh); dropped > 0)
    loaded.notes.push_back(
        text("head: ", dropped, " triangles of shoulders left out; the body has its own"));
  return loaded;
}

}  // namespace hair

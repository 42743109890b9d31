#include <libhair/guides/scenery.h>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/geometry/mesh_sdf.h>

namespace hair {

namespace {

PlanePlace placeOf(const Plane& before, const Plane& now) {
  // Find where the surface at p was before: at back · (p - now.point) + before.point.
  const glm::mat3 back = glm::mat3_cast(turnBetween(now.normal, before.normal));
  return {now.normal, now.point, glm::mat3(1) - back, now.point - before.point};
}

MeshPlace placeOf(const MeshCollider& before, const MeshCollider& now) {
  const glm::mat3 turn = glm::mat3_cast(now.worldFromMesh.rotation);
  const Bounds& box = now.sdf->box();
  const glm::vec3 centre = now.worldFromMesh.point(now.scale * box.centre());
  const glm::mat3 reach(glm::abs(turn[0]), glm::abs(turn[1]), glm::abs(turn[2]));
  const glm::vec3 half = reach * (0.5f * now.scale * box.size());
  return {now.sdf,
          glm::transpose(turn) * (1 / now.scale),
          turn,
          now.worldFromMesh.translation,
          now.scale,
          before.scale * glm::mat3_cast(before.worldFromMesh.rotation),
          before.worldFromMesh.translation,
          {centre - half, centre + half}};
}

Plane seenFrom(glm::vec3 origin, Plane plane) {
  plane.point -= origin;
  return plane;
}
MeshCollider seenFrom(glm::vec3 origin, MeshCollider mesh) {
  mesh.worldFromMesh.translation -= origin;
  return mesh;
}

template <class Collider, class Place>
void cut(const char* kind, glm::vec3 origin, std::span<const Collider> before,
         std::span<const Collider> after, std::size_t substeps, std::vector<Place>& places) {
  if (before.empty()) before = after;
  require(before.size() == after.size(), "stepGuides: ", before.size(), ' ', kind, " before and ",
          after.size(), " after; they must be as many, or none before: they stood");
  const auto at = [&](std::size_t i, std::size_t s) {
    return blend(seenFrom(origin, before[i]), seenFrom(origin, after[i]),
                 static_cast<float>(s) / static_cast<float>(substeps));
  };
  places.clear();
  for (std::size_t s = 0; s < substeps; ++s)
    for (std::size_t i = 0; i < after.size(); ++i)
      places.push_back(placeOf(at(i, s), at(i, s + 1)));
}

}  // namespace

void cutScenery(const Scenery& before, const Scenery& after, glm::vec3 origin, std::size_t substeps,
                std::vector<PlanePlace>& planes, std::vector<MeshPlace>& meshes) {
  validate(before);
  validate(after);
  cut("planes", origin, before.planes, after.planes, substeps, planes);
  cut("meshes", origin, before.meshes, after.meshes, substeps, meshes);
}

}  // namespace hair

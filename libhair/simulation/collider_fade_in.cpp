#include <libhair/simulation/collider_fade_in.h>

#include <algorithm>

#include <libhair/geometry/mesh_sdf.h>

namespace hair {

ColliderFadeIn::ColliderFadeIn(const BodyState& body, const GuideStrands& guides)
    : worldFromHead_(body.worldFromHead),
      full_{{body.capsules.begin(), body.capsules.end()},
            {body.scenery.planes.begin(), body.scenery.planes.end()},
            {body.scenery.meshes.begin(), body.scenery.meshes.end()}},
      now_(full_) {
  for (const Plane& plane : full_.planes) {
    float lowest = 0;
    for (std::size_t g = 0; g < guides.guideCount(); ++g)
      for (std::uint32_t i = 0; i < guides.pointsPerGuide(); ++i)
        lowest = std::min(lowest, distanceAndGradient(plane, guides.point(g, i)).w);
    below_.push_back(-lowest);
  }
}

BodyState ColliderFadeIn::at(float share) {
  for (std::size_t c = 0; c < full_.capsules.size(); ++c)
    now_.capsules[c].radius = share * full_.capsules[c].radius;
  for (std::size_t p = 0; p < full_.planes.size(); ++p)
    now_.planes[p].point = full_.planes[p].point - (1 - share) * below_[p] * full_.planes[p].normal;
  for (std::size_t m = 0; m < full_.meshes.size(); ++m) {
    // Scale about the centre of its box. A scale of 0 is invalid.
    const MeshCollider& mesh = full_.meshes[m];
    const float size = std::max({share, 0.01f, kSmallestMeshScale / mesh.scale});
    now_.meshes[m].scale = size * mesh.scale;
    now_.meshes[m].worldFromMesh.translation =
        mesh.worldFromMesh.point((1 - size) * mesh.scale * mesh.sdf->box().centre());
  }
  return {worldFromHead_, now_.capsules, {now_.planes, now_.meshes}};
}

}  // namespace hair

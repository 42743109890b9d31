#include <libhair/growing_body.h>

#include <algorithm>

#include <libhair/model/mesh_sdf.h>

namespace hair {

GrowingBody::GrowingBody(const BodyState& body, const GuideStrands& guides)
    : full_(body),
      capsules_(body.capsules.begin(), body.capsules.end()),
      planes_(body.scenery.planes.begin(), body.scenery.planes.end()),
      meshes_(body.scenery.meshes.begin(), body.scenery.meshes.end()) {
  for (const Plane& plane : planes_) {
    float lowest = 0;
    for (std::size_t g = 0; g < guides.guideCount(); ++g)
      for (std::uint32_t i = 0; i < guides.pointsPerGuide(); ++i)
        lowest = std::min(lowest, distanceAndGradient(plane, guides.point(g, i)).w);
    below_.push_back(-lowest);
  }
}

BodyState GrowingBody::at(float share) {
  for (std::size_t c = 0; c < capsules_.size(); ++c)
    capsules_[c].radius = share * full_.capsules[c].radius;
  const Scenery& whole = full_.scenery;
  for (std::size_t p = 0; p < planes_.size(); ++p)
    planes_[p].point = whole.planes[p].point - (1 - share) * below_[p] * planes_[p].normal;
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    // About its middle; a mesh of no size is none.
    const MeshCollider& mesh = whole.meshes[m];
    const float size = std::max(share, 0.01f);
    meshes_[m].scale = size * mesh.scale;
    meshes_[m].worldFromMesh.translation =
        mesh.worldFromMesh.point((1 - size) * mesh.scale * mesh.sdf->box().centre());
  }
  return {full_.worldFromHead, capsules_, {planes_, meshes_}};
}

}  // namespace hair

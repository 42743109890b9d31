#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/guide_strands.h>

namespace HAIR_API hair {

/// Stretch, penetration and speed of the guides at one moment.
struct GuideStats {
  float stretchMax = 0;      ///< max of |l - l0| / l0 over all links
  float stretchRms = 0;      ///< root mean square of the same
  float penetrationMax = 0;  ///< depth of the deepest guide point in a collider, metres; 0: none
  double kineticEnergy = 0;  ///< of the guides themselves, joules
  float speedMax = 0;        ///< m/s
};

/// Measures the guides against these colliders. Points groomed inside the head count by the depth
/// beyond that of the groom; points of a strand whose anchored points are covered by a collider, by
/// the depth beyond what contact.h allows there; roots not at all.
GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head,
                         const Scenery& scenery = {});

}  // namespace hair

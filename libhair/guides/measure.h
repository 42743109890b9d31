#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/guide_strands.h>

namespace HAIR_API hair {

/// How well the guides keep what they promise, now.
struct GuideStats {
  float stretchMax = 0;      ///< max of |l - l0| / l0 over all links
  float stretchRms = 0;      ///< root of the mean square of the same
  float penetrationMax = 0;  ///< deepest guide point inside a collider, metres; 0: none is
  double kineticEnergy = 0;  ///< of the guides themselves, joules
  float speedMax = 0;        ///< m/s
};

/// Points groomed inside the head count by how much deeper than groomed they are, points of a
/// strand whose root a collider has swallowed by how much deeper than the root; roots not at all.
GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head,
                         const Scenery& scenery = {});

}  // namespace hair

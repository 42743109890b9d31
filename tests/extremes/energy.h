#pragma once

#include <libhair/guides/guide_strands.h>

namespace hair::extremes {

/// What guides have of motion and of energy, relative to their head; per kilogram of the guide that
/// has most of it.
struct Energy {
  double kinetic = 0;  ///< J/kg, of the motion relative to the head's own
  double total = 0;    ///< with gravity's (0 at the roots) and bending's, J/kg
  double speed = 0;    ///< m/s, of the fastest point, relative to the head's own motion there
};

/// `before`: where the head was `seconds` ago, from where it moved evenly.
Energy energyOf(const GuideStrands& guides, const RigidTransform& before, double seconds,
                glm::vec3 gravity);

}  // namespace hair::extremes

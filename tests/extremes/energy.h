#pragma once

#include <libhair/guides/guide_strands.h>

namespace hair::extremes {

/// Energy of the guide that has most of it, joules per kilogram of it: of its motion relative to
/// its head's own, of gravity (0 at its root) and of bending. `before`: where the head was
/// `seconds` ago, from where it moved evenly.
double energyOf(const GuideStrands& guides, const RigidTransform& before, double seconds,
                glm::vec3 gravity);

}  // namespace hair::extremes

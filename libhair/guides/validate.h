#pragma once

#include <span>

#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/guide_strands.h>

namespace hair {

// Input validation of stepGuides: refuses what a kernel could only turn into NaN.

/// Throws Error for a head that is not finite, beyond 1e8 m, or whose rotation is not of unit
/// length (to 1 %).
void validate(const RigidTransform& worldFromHead);

/// Throws Error, naming the capsule, for one that is not finite, beyond 1e8 m, or of a radius not
/// in [0, 1e8) m.
void validate(std::span<const Capsule> capsules);

/// Throws Error for a push that is not finite, or with a component of 1e6 m/s² or more.
void validatePush(std::span<const LaneVec3> push);

/// Spacing of the floats next to `metres`, metres.
float floatSpacing(float metres);

/// Origin of the positions in a substep: the multiple of 16 m nearest to the head. Far from the
/// world's origin, small movements would be lost to rounding and hair would stick.
glm::vec3 stepOrigin(const RigidTransform& worldFromHead);

/// World positions are floats, whose spacing grows with the distance from the origin. Throws Error
/// where rounding alone could stretch a link by more than a hundredth: 2 cm links beyond 1 km, 1 mm
/// links beyond 64 m. The remedy is a nearer origin (moveOrigin).
void requirePrecision(const GuideStrands& guides, const RigidTransform& worldFromHead);

}  // namespace hair

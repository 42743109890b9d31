#pragma once

#include <span>

#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/guide_strands.h>

namespace hair {

/// The door of a step: what a kernel could only turn into NaN is refused here. All throw Error.

/// A place for a head: finite, within 1e8 m, rotation of unit length (to 1 %).
void validate(const RigidTransform& worldFromHead);

/// Finite, within 1e8 m, radius in [0, 1e8) m.
void validate(std::span<const Capsule> capsules);

/// Accelerations of any size below 1e6 m/s².
void validatePush(std::span<const LaneVec3> push);

/// Between two floats next to each other, metres.
float floatSpacing(float metres);

/// Far from the origin the floats of a substep would swallow small movements, and hair would stick
/// where it is: positions in it count from a place near the head then, a multiple of 16 m.
glm::vec3 stepOrigin(const RigidTransform& worldFromHead);

/// World positions are floats: the farther from the origin, the farther apart. Refuses a head where
/// rounding alone would stretch a link by more than a hundredth: 2 cm links beyond 1 km, 1 mm links
/// beyond 64 m. The way out is an origin that is nearer (moveOrigin).
void requirePrecision(const GuideStrands& guides, const RigidTransform& worldFromHead);

}  // namespace hair

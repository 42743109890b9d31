#pragma once

#include <span>
#include <vector>

#include <libhair/geometry/colliders.h>
#include <libhair/motion/body.h>

namespace hair {

/// Capsules around the bones, with a person's proportions scaled by the skeleton's size: neck,
/// trapezius, shoulders, chest, waist, hips, arms, hands, legs, feet; no head (it has its own
/// signed distance field). A skeleton that is not understood gets one capsule a bone, and a note.
void fitCapsules(Body& body);

/// The capsules of a pose, in the order of body.capsules; `out` is [body.capsules.size()].
void placeCapsules(const Body& body, std::span<const RigidTransform> worldFromJoint,
                   std::span<Capsule> out);

/// Thins the arms where they press against trunk or head, so that hair caught between them has
/// somewhere to be: in a pinch no position is outside of both. `capsules` as placed above.
void makeRoomForHair(const Body& body, const RigidTransform& worldFromHead,
                     std::span<Capsule> capsules);

}  // namespace hair

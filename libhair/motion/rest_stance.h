#pragma once

#include <span>
#include <vector>

#include <libhair/motion/body.h>

namespace hair {

/// The pose with all joint rotations zero.
std::vector<RigidTransform> zeroPose(const Skeleton& skeleton);

/// Whether a body stands along a direction: head over hips over feet, shoulders level.
bool standsAlong(const BodyMap& map, std::span<const RigidTransform> pose, glm::vec3 up);

/// Finds body.rest for a complete body.map, but for the origin of body space. Where the zero pose
/// stands, whichever way, that is the stance. Else it is put together from the rig: each joint's
/// frame along its bone, and about the bone as the frame of its parent is, or by the line between
/// the shoulders; to the axes of the frame, where they are near. Of the clip only which way the
/// lateral axis of body and limbs lies about a bone is learnt, which neither bow nor crawl changes.
/// True where the zero pose stands.
bool findRestStance(const Clip& clip, Body& body);

}  // namespace hair

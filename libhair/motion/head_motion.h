#pragma once

#include <span>

#include <libhair/motion/body.h>

namespace hair {

/// Head space (see Groom) in a pose of the body, [jointCount].
RigidTransform worldFromHead(const Body& body, std::span<const RigidTransform> worldFromJoint);

/// Where the trunk faces in a pose: unit, normal to the line between the shoulders (hips, where it
/// has none) and to the spine.
glm::vec3 bodyFacing(const BodyMap& map, std::span<const RigidTransform> worldFromJoint);

}  // namespace hair

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/model/styles.h>

namespace HAIR_API hair {

/// Grows one guide from `root`: along the head away from the parting, then down, outside of head,
/// neck and shoulders, the farther out the farther it has come (so that hair from above lies over
/// hair from below), and never over the face. The result has settings.pointsPerGuide points, root
/// first, with equal links. `wisp` picks the variations that a wisp's guides share;
/// where its centre lies decides whether it falls before or behind the shoulders.
void combGuide(const StyleSettings& settings, const MeshSdf& headSdf, glm::vec3 root,
               glm::vec3 centre, std::uint32_t wisp, std::span<glm::vec3> guide);

/// Moves p to the side of the face, about the head's vertical axis, if it hangs before it.
glm::vec3 outOfFace(glm::vec3 p);

/// Points along a polyline at equal straight distances from each other, to float precision.
void equalLinks(std::span<const glm::vec3> dense, std::span<glm::vec3> points);

}  // namespace hair

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/model/styles.h>

namespace hair {

/// Grows one guide from `root`: along the head away from the parting, then down, at a clearance
/// from head, neck and shoulders that grows along the guide (so that hair from above lies over hair
/// from below), and never over the face. The result has settings.pointsPerGuide points, root first,
/// with equal links. `wisp` is the key of the random variations that a wisp's guides share; its
/// `centre` determines whether it falls in front of the shoulders or behind them.
void combGuide(const StyleSettings& settings, const MeshSdf& headSdf, glm::vec3 root,
               glm::vec3 centre, std::uint32_t wisp, std::span<glm::vec3> guide);

/// Rotates p about the head's vertical axis to the side of the face if it is in front of the face.
glm::vec3 outOfFace(glm::vec3 p);

/// Points along a polyline at equal straight distances from each other, to float precision.
void equalLinks(std::span<const glm::vec3> dense, std::span<glm::vec3> points);

}  // namespace hair

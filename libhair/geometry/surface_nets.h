#pragma once

#include <functional>

#include <libhair/core/strands.h>
#include <libhair/geometry/triangle_mesh.h>

namespace hair {

/// A scalar field in metres: negative inside, zero on the surface, positive outside. Called from
/// many threads at once.
using ScalarField = std::function<float(glm::vec3)>;

/// Triangles of the surface field = 0 inside `box`: one vertex in each cell that the surface
/// passes through (naive surface nets, Gibson 1998), then moved onto the surface by Newton steps
/// along the gradient. Normals are the field's gradient. Closed where the surface does not leave
/// the box. Edges are about `cell` (metres) long.
TriangleMesh surfaceNets(const ScalarField& field, const Bounds& box, float cell);

}  // namespace hair

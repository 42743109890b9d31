#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/geometry/mesh_sdf.h>

namespace HAIR_API hair {

/// MeshSdf(mesh, cell, margin), of which there is one for all who ask for the same: the same
/// positions, triangles, cell and margin, wherever the mesh itself stands in memory. A field takes
/// seconds to build and tens of megabytes; it goes with the last who holds it. Any thread may ask
/// at any time; two that ask at once for what there is not yet may both build it, and get one.
/// Throws Error as MeshSdf does.
std::shared_ptr<const MeshSdf> sharedSdf(const TriangleMesh& mesh, float cell = 4e-3f,
                                         float margin = 0.03f);

}  // namespace hair

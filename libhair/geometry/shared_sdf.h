#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/geometry/mesh_sdf.h>

namespace HAIR_API hair {

/// MeshSdf(mesh, cell, margin), shared between all callers with equal positions, triangles, cell
/// and margin (compared by value). A field takes seconds to build and tens of megabytes; it is
/// freed with its last owner. Thread-safe: two threads that ask for a new field at once may both
/// build it, but get the same one. Throws Error as MeshSdf does.
std::shared_ptr<const MeshSdf> sharedSdf(const TriangleMesh& mesh, float cell = 4e-3f,
                                         float margin = 0.03f);

}  // namespace hair

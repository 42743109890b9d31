#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Rasterises an opaque object into the map of the hair (Bertails et al. 2005, section 6); all
/// behind it is in shadow. Call after deposit() and before computeTransmittance().
///
/// Fills one cell of each column: the first whose front face's centre is at least half a cell
/// inside the object, so that skin does not shadow the hair that lies on it. The shadow starts up
/// to two cells below the surface and is about half a cell smaller all around: objects thinner than
/// two cells cast none, and finer contact shadows need a finer map. Shadow edges are as soft as the
/// map's filter is wide.
///
/// Sphere-traces each column through the object's bounds.
void occlude(const MeshSdf& mesh, const RigidTransform& worldFromMesh, DensityMap& map);
/// The same for the capsules of a body.
void occlude(std::span<const Capsule> capsules, DensityMap& map);

}  // namespace hair

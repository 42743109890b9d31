#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Puts opaque things into the same map as the hair (Bertails et al. 2005, section 6): all that is
/// behind them is dark. After deposit(), before computeTransmittance().
///
/// In each column of cells only the first one inside is filled; the light ends there. It is filled
/// where the middle of its front face is at least half a cell inside, so that hair on the lit side
/// is not shadowed by the skin that it lies on. The shadow then begins up to two cells below the
/// skin, and is smaller than the thing by about half a cell all around: things thinner than two
/// cells throw none, and finer contact shadows need a finer map. Along its outline, as the light
/// sees it, a shadow is as soft as the map's filter is wide.
///
/// Costs a walk along each column through the thing's bounds, in steps as long as the distance to
/// it.
void occlude(const MeshSdf& mesh, const RigidTransform& worldFromMesh, DensityMap& map);
/// The same for a body.
void occlude(std::span<const Capsule> capsules, DensityMap& map);

}  // namespace hair

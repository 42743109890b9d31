#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/roots.h>

namespace HAIR_API hair {

/// A strand for each root (Yuksel et al. 2009, section 3.1): the root's weights, applied to the
/// corners of its bundle's face in layers 0 ... n_j, are points; a C1 Catmull-Rom spline through
/// them is the hair, of which `points` (>= 2) are kept, at equal lengths along it (to about 1 %).
///
/// The spline is the centripetal one, whose knots are sqrt(distance) apart (Yuksel, Schaefer,
/// Keyser 2011, "Parameterization and Applications of Catmull-Rom Curves"): the uniform one has
/// loops where one layer lies close on another, as after Layer Insert or an extrusion by little.
/// Beyond its ends it goes on by reflection, P[-1] = 2 P[0] - P[1]: hair leaves the scalp towards
/// the first layer. The first point is the root on the scalp's face, the last lies in the tip's,
/// both as the weights have them, bit for bit. Layers that coincide at a strand count once; only a
/// strand whose layers all do has segments without length.
///
/// Roots do not depend on vertex positions: after an edit of positions only this is recomputed.
/// `strands` is overwritten and keeps its memory. The same bits for any number of
/// threads. Throws Error for fewer than 2 points, or roots that do not fit the mesh.
void traceStrands(const HairMesh& mesh, const HairMeshRoots& roots, std::uint32_t points,
                  StrandSet& strands);

}  // namespace hair

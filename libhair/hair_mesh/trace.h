#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/roots.h>

namespace HAIR_API hair {

/// Traces a strand for each root (Yuksel et al. 2009, section 3.1): applies the root's weights to
/// the corners of its bundle's face in layers 0 ... n_j, and samples the C1 Catmull-Rom spline
/// through the resulting points at `points` (>= 2) points of equal distance along it (to about 1
/// %).
///
/// The spline is the centripetal one, whose knots are sqrt(distance) apart (Yuksel, Schaefer,
/// Keyser 2011, "Parameterization and Applications of Catmull-Rom Curves"): the uniform one has
/// loops where layers are close to each other, as after Layer Insert or a short extrusion. It is
/// extended at its ends by reflection, P[-1] = 2 P[0] - P[1]: hair leaves the scalp towards the
/// first layer. The first and the last point are the weighted sums of the corners of the scalp's
/// and the tip's face, bit for bit. Layers that coincide at a strand count once; segments have no
/// length only where all layers of a strand coincide.
///
/// Roots do not depend on vertex positions: after an edit of positions only this is recomputed.
/// `strands` is overwritten and keeps its memory. The same bits for any number of
/// threads. Throws Error for fewer than 2 points, or roots that do not fit the mesh.
void traceStrands(const HairMesh& mesh, const HairMeshRoots& roots, std::uint32_t points,
                  StrandSet& strands);

}  // namespace hair

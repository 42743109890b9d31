#pragma once

#include <cstdint>

#include <libhair/core/lanes.h>
#include <libhair/guides/contact.h>

namespace hair {

/// One Newton iteration on all link constraints |x_(i+1) - x_i| = l_i of eight strands at once.
///
/// With C the violations, J their gradients (± d_i on the two ends) and W the inverse masses:
///     (J W Jᵀ) lambda = -C,    x += W Jᵀ lambda.
/// A link shares a point with the one before and the one after, so J W Jᵀ is tridiagonal. A point
/// in contact may only slide: its W is w (I - n nᵀ), which keeps the system tridiagonal and lets
/// low stretch and no penetration hold together.
///
/// `touching` [points]: lanes where a point rests on its plane. `lambda` [links] is added to
/// (mass per linear density · metres): divided by h² it is minus the tension.
void correctLinks(std::uint32_t points, const Lanes* linkLength, const Lanes* inverseMass,
                  const ContactPlane* planes, const LaneMask* touching, Lanes* lambda, LaneVec3* x);

/// Root to tip: puts every point at exactly its link's length from the one before, and outside its
/// plane where that is within reach. What Newton has left is a small fraction of a link.
void finishLinks(std::uint32_t points, const Lanes* linkLength, const ContactPlane* planes,
                 LaneVec3* x);

}  // namespace hair

#pragma once

#include <vector>

#include <libhair/guides/guide_strands.h>

namespace hair {

/// Factors L·D·Lᵀ of the implicit bending system of every guide, for one length of substep.
///
/// With y the points at the end of the substep, x where their velocities alone take them, M the
/// masses, f the other forces and E the bending energy with rest curvatures held (GuideStrands),
/// implicit Euler is
///     M (y - x) / h² = f - grad E(y):     (M / h² + K) (y - x) = f - grad E(x).
/// Damping takes kappa_i · bendDamping · (rate of the strain) to the torque of joint i, which makes
/// K stiffer by bendDamping / h.
/// At rest the right-hand side is zero, so neither rounding nor the factors can move a groom.
/// K couples a point with two neighbours on each side, is the same for x, y and z, and does not
/// change while h stays: one pentadiagonal factorisation, then two sweeps a substep.
struct BendingFactors {
  float substep = 0;            ///< h they were made for, seconds
  float damping = 0;            ///< bendDamping / h they were made for
  std::vector<Lanes> inverseD;  ///< [groupCount · pointsPerGuide]; point 0 is the fixed root
  std::vector<Lanes> below1;    ///< L(i, i - 1)
  std::vector<Lanes> below2;    ///< L(i, i - 2)
};

/// Makes the factors unless they are there for this substep and damping (seconds) already. One set
/// of factors goes with one GuideStrands.
void factorBending(const GuideStrands& guides, float substep, float bendDamping,
                   BendingFactors& factors);

}  // namespace hair

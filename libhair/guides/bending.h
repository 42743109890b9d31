#pragma once

#include <vector>

#include <libhair/guides/guide_strands.h>

namespace hair {

/// Factors L·D·Lᵀ of the implicit bending system of every guide, for one length of substep.
///
/// With y the points at the end of the substep, x the points predicted from their velocities, M the
/// masses, f the other forces and E the bending energy with fixed rest curvatures (GuideStrands),
/// implicit Euler is
///     M (y - x) / h² = f - grad E(y):     (M / h² + K) (y - x) = f - grad E(x).
/// Damping adds kappa_i · bendDamping · (rate of the strain) to the torque of joint i, which scales
/// K by 1 + bendDamping / h. At rest the right-hand side is zero, so that neither rounding nor the
/// factors can move a groom. K couples a point with two neighbours on each side, is the same for x,
/// y and z, and is constant while h is: one pentadiagonal factorisation, then two sweeps per
/// substep.
///
/// Tension is one of the forces f, along the links before the substep. Points u between links with
/// tension T and length l have the lateral stiffness S, u' S u = sum T |u_(i+1) - u_i|² / l, at
/// most 4 T / l for a mass m: symplectic steps are stable for 4 T h² / (m l) < 4. The solver limits
/// the tension to a quarter of that (`mostTension`). Where the rest tension exceeds the limit, as
/// on a short link that carries long ones, its S joins K: a mode with the ratio w = S h² / m then
/// moves by w / (1 + w) of its force, below 1 for any T, and slow modes, w << 1, move as before.
struct BendingFactors {
  float substep = 0;            ///< h of these factors, seconds
  float damping = 0;            ///< bendDamping / h of these factors
  float weight = 0;             ///< gravity over that of the rest shape, >= 1
  std::vector<Lanes> inverseD;  ///< [groupCount · pointsPerGuide]; point 0 is the fixed root
  std::vector<Lanes> below1;    ///< L(i, i - 1)
  std::vector<Lanes> below2;    ///< L(i, i - 2)
  /// Largest tension of a link that a substep applies; [groupCount · linksPerGuide], m²/s².
  std::vector<Lanes> mostTension;
  /// The same for compression, to which no rest tension is added.
  std::vector<Lanes> mostCompression;
};

/// Makes the factors, unless they are up to date, for this substep and damping (seconds) and this
/// `weight`: gravity over that of the rest shape. Use one set of factors per GuideStrands.
void factorBending(const GuideStrands& guides, float substep, float bendDamping, float weight,
                   BendingFactors& factors);

}  // namespace hair

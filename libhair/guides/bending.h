#pragma once

#include <vector>

#include <libhair/core/api.h>
#include <libhair/guides/guide_strands.h>

namespace HAIR_API hair {

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
///
/// Tension is among the forces f, along the links as they were before the substep. Points u between
/// links with tension T and length l have the lateral stiffness S, u' S u = sum T |u_(i+1) - u_i|²
/// / l, at most 4 T / l for a mass m: symplectic steps are stable for 4 T h² / (m l) < 4, a quarter
/// of which is what the solver lets a link pull (`mostTension`). Where the rest tension is more
/// than that, as on a short link that carries long ones, its S joins K: a mode with the ratio w = S
/// h² / m then moves by w / (1 + w) of its force, below 1 whatever T is, and slow modes, w << 1, as
/// before.
struct BendingFactors {
  float substep = 0;            ///< h they were made for, seconds
  float damping = 0;            ///< bendDamping / h they were made for
  float weight = 0;             ///< of the hair, of that at rest, >= 1
  std::vector<Lanes> inverseD;  ///< [groupCount · pointsPerGuide]; point 0 is the fixed root
  std::vector<Lanes> below1;    ///< L(i, i - 1)
  std::vector<Lanes> below2;    ///< L(i, i - 2)
  /// Tension of a link that a substep goes by, at the most; [groupCount · linksPerGuide], m²/s².
  std::vector<Lanes> mostTension;
  /// The same of compression, which has no rest tension to be held by.
  std::vector<Lanes> mostCompression;
};

/// Makes the factors unless they are there for this substep and damping (seconds) and this weight
/// of the hair, of that at rest, already. One set of factors goes with one GuideStrands.
void factorBending(const GuideStrands& guides, float substep, float bendDamping, float weight,
                   BendingFactors& factors);

}  // namespace hair

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

/// The part of a group's arrays that bending reads (GuideStrands, BendingFactors), and its root.
struct BendingGroup {
  std::uint32_t points;
  const LaneVec3* curvature;
  const Lanes *jointStiffness, *linkLength;
  const Lanes *inverseD, *below1, *below2;
  float damping;  ///< bendDamping / h
};

/// The frame at the roots of a group, world space.
struct RootFrame {
  LaneVec3 tangent, normal;
};

/// Moves the points x[1 .. points - 1] of one group to y above. `before` and `rootBefore`: where
/// the points and the root's frame were before the substep. `force` [points] is f per linear
/// density (m²/s²), overwritten.
void solveBending(const BendingGroup& group, const RootFrame& root, const RootFrame& rootBefore,
                  const LaneVec3* before, LaneVec3* force, LaneVec3* x);

}  // namespace hair

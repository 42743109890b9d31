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
/// At rest the right-hand side is zero, so neither rounding nor the factors can move a groom.
/// K couples a point with two neighbours on each side, is the same for x, y and z, and does not
/// change while h stays: one pentadiagonal factorisation, then two sweeps a substep.
struct BendingFactors {
  float substep = 0;            ///< h they were made for, seconds
  std::vector<Lanes> inverseD;  ///< [groupCount · pointsPerGuide]; point 0 is the fixed root
  std::vector<Lanes> below1;    ///< L(i, i - 1)
  std::vector<Lanes> below2;    ///< L(i, i - 2)
};

/// Makes the factors unless they are there for this substep already.
void factorBending(const GuideStrands& guides, float substep, BendingFactors& factors);

/// Moves the points x[1 .. points - 1] of one group to y above. `force` [points] is f per linear
/// density (m²/s²), overwritten. `tangent` and `normal`: the root's frame, world space. The other
/// pointers: the group's part of the arrays of GuideStrands and BendingFactors.
void solveBending(std::uint32_t points, const LaneVec3* curvature, const Lanes* jointStiffness,
                  const Lanes* linkLength, const Lanes* inverseD, const Lanes* below1,
                  const Lanes* below2, LaneVec3 tangent, LaneVec3 normal, LaneVec3* force,
                  LaneVec3* x);

}  // namespace hair

// The implicit bending step of sixteen strands at once; included by the solver's kernel
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_BENDING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_BENDING_INL_H
#undef HAIR_GUIDES_BENDING_INL_H
#else
#define HAIR_GUIDES_BENDING_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/guides/bending.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// The part of a group's arrays that bending reads (GuideStrands, BendingFactors).
struct BendingGroup {
  std::uint32_t points;
  const LaneVec3* curvature;
  const Lanes *jointStiffness, *inverseLength;
  const Lanes *inverseD, *below1, *below2;
  float damping;  ///< bendDamping / h
};

/// The frame at the roots of a group, world space.
struct RootFrame {
  Vec3 tangent, normal;
};

/// A frame carried along a chain by parallel transport: at joint i, that of link i - 1.
class CarriedFrame {
 public:
  HWY_INLINE explicit CarriedFrame(const RootFrame& root)
      : tangent_(root.tangent), normal_(root.normal), binormal_(cross(tangent_, normal_)) {}

  HWY_INLINE Vec3 fromWorld(const Vec3& v) const {
    return {dot(v, normal_), dot(v, binormal_), dot(v, tangent_)};
  }
  HWY_INLINE Vec3 toWorld(const Vec3& v) const {
    return v.x * normal_ + v.y * binormal_ + v.z * tangent_;
  }
  /// Transports the frame to the next link, whose direction is `to` (unit). Equals transport() in
  /// transform.h for a vector at a right angle to the tangent.
  HWY_INLINE void over(const Vec3& to) {
    const Vec3 h = tangent_ + to;
    // Divide first: the quotient does not depend on the normal, which depends on the last joint.
    const Floats share = Floats(2.0f) / max(dot(h, h), Floats(1e-12f));
    normal_ = normal_ - (share * dot(normal_, to)) * h;
    tangent_ = to;
    binormal_ = cross(tangent_, normal_);
  }

 private:
  Vec3 tangent_, normal_, binormal_;
};

/// One implicit Euler step: moves the points x[1 .. points - 1] of one group to y of
/// BendingFactors. `before` [links] and `rootBefore`: directions of the links (unit) and frame of
/// the root before the substep. `force` [points] is f per linear density (m²/s²), overwritten.
HWY_INLINE void solveBending(const BendingGroup& group, const RootFrame& root,
                             const RootFrame& rootBefore, const Vec3* before, Vec3* force,
                             Vec3* x) {
  const std::uint32_t links = group.points - 1;
  const Vec3 zero(glm::vec3(0));
  CarriedFrame now(root), then(rootBefore);
  // Links over their rest lengths, not of unit length: E is then quadratic in the points.
  Vec3 d = root.tangent, dThen = rootBefore.tangent;
  // Form the right-hand side, f - grad E(x) - damping, from root to tip, and follow with the
  // forward sweep of L as soon as a point has all of its force. The root is fixed.
  Vec3 last = zero, beforeLast = zero;
  Floats inverseLength = 0.0f;
  for (std::uint32_t i = 0; i < links; ++i) {
    const Floats inverseLengthBefore = inverseLength;
    inverseLength = group.inverseLength[i];
    const Vec3 next = inverseLength * (x[i + 1] - x[i]);
    // Find the torque g of joint i. Its damping compares strains in the carried frames, in which a
    // rotation of the whole strand with the head does not change them.
    const Vec3 bent = now.fromWorld(next - d), bentThen = then.fromWorld(before[i] - dThen);
    const Vec3 strain = bent - Vec3(group.curvature[i]);
    const Vec3 g = Floats(group.jointStiffness[i]) *
                   now.toWorld(strain + Floats(group.damping) * (bent - bentThen));
    // Apply g_i to link i, and its opposite to link i - 1. This completes the force on point i - 1.
    if (i > 1) {
      const Vec3 swept = (force[i - 1] - inverseLengthBefore * g) -
                         Floats(group.below1[i - 1]) * last -
                         Floats(group.below2[i - 1]) * beforeLast;
      force[i - 1] = swept;
      beforeLast = last, last = swept;
    }
    if (i > 0) force[i] = force[i] + (inverseLength + inverseLengthBefore) * g;
    force[i + 1] = force[i + 1] - inverseLength * g;
    // Carry both frames to the next joint.
    d = next, dThen = before[i];
    now.over((Floats(1.0f) / max(length(d), Floats(1e-12f))) * d);
    then.over((Floats(1.0f) / max(length(dThen), Floats(1e-12f))) * dThen);
  }
  // Sweep the last two points, but never the root.
  for (std::uint32_t i = links > 1 ? links - 1 : 1; i <= links; ++i) {
    const Vec3 swept =
        force[i] - Floats(group.below1[i]) * last - Floats(group.below2[i]) * beforeLast;
    force[i] = swept;
    beforeLast = last, last = swept;
  }
  // Sweep back with D and Lᵀ, and move the points.
  Vec3 after = zero, afterNext = zero;
  Floats below1 = 0.0f, below2 = 0.0f, below2After = 0.0f;
  for (std::uint32_t i = links; i >= 1; --i) {
    const Vec3 move =
        Floats(group.inverseD[i]) * force[i] - below1 * after - below2After * afterNext;
    x[i] = x[i] + move;
    below2After = below2, below2 = group.below2[i], below1 = group.below1[i];
    afterNext = after, after = move;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

// The plane that stands for a collider near a point during one substep; included by kernels
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_CONTACT_PLANE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_CONTACT_PLANE_INL_H
#undef HAIR_GUIDES_CONTACT_PLANE_INL_H
#else
#define HAIR_GUIDES_CONTACT_PLANE_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/guides/contact.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// Metres; farther than any distance of interest in a substep.
inline constexpr float kFar = 1e3f;

/// The half-space normal · x >= offset in which a point of a strand must stay for one substep, and
/// the motion of the surface during it, metres.
struct ContactPlane {
  Vec3 normal;
  Floats offset;
  Vec3 surfaceMove;
  Floats distance;  ///< of the point to the plane when it was found, metres; no collider is nearer
};

/// The distance that points must keep from a collider, metres: from the axis of a capsule, from the
/// surface of others. Reduced where the collider covers the rest positions of anchored points:
///
///     full           _______
///                   /           slope kReachGrowth, over the length `way` of the strand
///     anchored   __/
///           point 1 2 3 4 5 ...
///
/// anchored[i] is that of point i + 1: the distance of its rest position and half the skin.
struct RequiredDistance {
  Floats anchored[kAnchoredPoints];
  float full;

  /// `heldAt` [i]: the distance of the rest position of point i + 1, metres.
  HWY_INLINE void set(const Floats* heldAt, float full_, float skin) {
    full = full_;
    for (std::uint32_t i = 0; i < kAnchoredPoints; ++i)
      anchored[i] = min(heldAt[i] + Floats(0.5f * skin), Floats(full));
  }
  HWY_INLINE Floats of(std::uint32_t point, Floats way) const {
    return point <= kAnchoredPoints
               ? anchored[point - 1]
               : min(anchored[kAnchoredPoints - 1] + Floats(kReachGrowth) * way, Floats(full));
  }
  HWY_INLINE bool covered() const {
    bool any_ = false;
    for (const Floats& reach : anchored) any_ |= any(reach < Floats(full));
    return any_;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

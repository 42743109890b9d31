// What a collider is to a point for one substep; included by kernels (core/simd-inl.h).
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

// Farther than anything reaches in a substep.
inline constexpr float kFar = 1e3f;

/// The half-space normal · x >= offset in which a point of a strand must stay for one substep, and
/// how far the surface moved in it.
struct ContactPlane {
  Vec3 normal;
  Floats offset;
  Vec3 surfaceMove;
  Floats distance;  ///< of the point to the plane when it was found; no collider is nearer
};

/// How far points must keep from a collider. [i]: point i + 1; points after the last of them that
/// far plus their way along the strand times kReachGrowth; at most `full`. Counted from wherever
/// the collider's kind counts: a capsule from its axis, others from their surface.
struct Reach {
  Floats anchored[kAnchoredPoints];
  float full;

  /// `heldAt` [i]: how far the head holds point i + 1 from there.
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
  HWY_INLINE bool swallowed() const {
    bool any_ = false;
    for (const Floats& reach : anchored) any_ |= any(reach < Floats(full));
    return any_;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

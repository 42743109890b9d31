// Link constraints of sixteen strands at once, one link after the other; included by the solver's
// kernel (core/simd-inl.h).
#if defined(HAIR_GUIDES_RELAXATION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_RELAXATION_INL_H
#undef HAIR_GUIDES_RELAXATION_INL_H
#else
#define HAIR_GUIDES_RELAXATION_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/guides/links-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// One sweep of relaxation, root to tip, after van Overveld 1991, which Bertails et al. 2005 (4.1)
/// animate their guides with: each link in turn takes its rest length, its two ends moving in
/// proportion to their inverse masses,
///     lambda = (l - |e|) / (d · (W_i + W_(i+1)) d),  x_i -= W_i lambda d,  x_(i+1) += W_(i+1)
///     lambda d,
/// which disturbs the previous link; further sweeps reduce the error. This is correctLinks without
/// the coupling between links, with the same W (a point in contact may only slide) and arguments.
HWY_INLINE void relaxLinks(std::uint32_t points, const Lanes* linkLength, const Lanes* inverseMass,
                           const Contact* contacts, Vec3* x) {
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Vec3 e = x[i + 1] - x[i];
    const Floats lengthNow = max(length(e), Floats(1e-9f));
    const Vec3 d = (Floats(1.0f) / lengthNow) * e;
    const Vec3 back = Floats(inverseMass[i]) * slide(contacts[i], d);
    const Vec3 forth = Floats(inverseMass[i + 1]) * slide(contacts[i + 1], d);
    const Floats least = max(Floats(1e-6f) * Floats(inverseMass[i + 1]), Floats(kTiedPivot));
    const Floats give = max(dot(back + forth, d), least);
    const Floats lambda = (Floats(linkLength[i]) - lengthNow) / give;
    x[i] = x[i] - lambda * back;
    x[i + 1] = x[i + 1] + lambda * forth;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

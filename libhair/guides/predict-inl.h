// The first step of a substep, of sixteen strands at once; included by the solver's kernel
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_PREDICT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_PREDICT_INL_H
#undef HAIR_GUIDES_PREDICT_INL_H
#else
#define HAIR_GUIDES_PREDICT_INL_H
#endif

#include <libhair/guides/group-inl.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/motion/wind-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Scales all tensions of a strand by one factor, so that none exceeds what predict may apply.
/// Clamped one by one they would not balance, and throw light points between uneven links.
HWY_NOINLINE inline void scaleTensions(const Group& g) {
  Floats share = 1.0f;
  for (std::uint32_t i = 0; i + 1 < g.points; ++i) {
    const Floats t = g.tension[i];
    const Floats most = select(t > Floats(0.0f), Floats(g.mostTension[i]), g.mostCompression[i]);
    share = min(share, most / max(abs(t), Floats(1e-20f)));
  }
  for (std::uint32_t i = 0; i + 1 < g.points; ++i)
    store(share * Floats(g.tension[i]), g.tension[i]);
}

/// Distance from the head, metres, at which the air moves with half its speed.
inline constexpr float kCarriedAirRadius = 0.3f;

/// Adds the wind at p to the velocity of the air, m/s. `share`: of the wind; or null: 1.
HWY_NOINLINE inline void addWind(const WindField& wind, const Vec3& p, const Lanes* share,
                                 Vec3& air) {
  const Vec3 blown = blow(wind, p);
  air = air + (share ? Floats(*share) * blown : blown);
}

/// Predicts: x = position after time h at the current velocity; force = all forces but bending, per
/// linear density.
HWY_INLINE void predict(const Group& g, const GuideSettings& settings, const WindField* wind,
                        float h, const SubstepColliders& colliders, Scratch& s) {
  const float keep = 1.0f / (1.0f + settings.airDrag * h);
  // Find the head's velocity field. A point p carried by the head was at back · (p - now) + then a
  // time h ago, so its velocity is carry · (p - now) + drift.
  const glm::mat3 back = colliders.turnBefore * glm::transpose(colliders.turn);
  const glm::mat3 carry = (glm::mat3(1) - back) * (1.0f / h);
  const Vec3 drift((colliders.at - colliders.atBefore) * (1.0f / h)), now(colliders.at);
  const Vec3 gravity(settings.gravity);
  constexpr float kPerRadius2 = 1.0f / (kCarriedAirRadius * kCarriedAirRadius);
  // Apply the last tension along the last directions, clamped to what the bending system holds
  // (BendingFactors); the Newton iterations find the rest.
  if (g.hasUnevenLinks) scaleTensions(g);
  const auto pullOf = [&](std::uint32_t i) HWY_ATTR {
    const Floats tension =
        max(min(Floats(g.tension[i]), g.mostTension[i]), -Floats(g.mostCompression[i]));
    store(tension, g.tension[i]);
    return tension * s.directions[i];
  };
  Vec3 pull = pullOf(0);
  for (std::uint32_t i = 1; i < g.points; ++i) {
    // Let the air move with the head near it, and with the wind.
    const Vec3 p = g.position[i], fromHead = p - now;
    const Floats share = Floats(settings.carriedAir) /
                         (Floats(1.0f) + Floats(kPerRadius2) * dot(fromHead, fromHead));
    Vec3 air = share * (rotate(carry, fromHead) + drift);
    if (wind) addWind(*wind, p, g.windShare ? g.windShare + i : nullptr, air);
    // Sum gravity, the pull of the air and the push.
    Vec3 acceleration = gravity + Floats(keep * settings.airDrag) * air;
    if (g.push) acceleration = acceleration + Vec3(g.push[i]);
    // Move by the velocity with implicit drag, v' = (v + h drag · air) / (1 + h drag); its second
    // term is in the force.
    s.x[i] = p + Floats(h * keep) * Vec3(g.velocity[i]);
    // Add the tensions of the links on both sides.
    Vec3 force = Floats(g.mass[i]) * acceleration - pull;
    if (i + 1 < g.points) pull = pullOf(i), force = force + pull;
    s.force[i] = force;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

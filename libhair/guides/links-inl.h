// Link constraints of sixteen strands at once; included by the solver's kernel (core/simd-inl.h).
#if defined(HAIR_GUIDES_LINKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_LINKS_INL_H
#undef HAIR_GUIDES_LINKS_INL_H
#else
#define HAIR_GUIDES_LINKS_INL_H
#endif

#include <libhair/core/simd-inl.h>
#include <libhair/guides/contact-inl.h>
#include <libhair/guides/rest_shape.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// What a point may touch. Most touch nothing: `near` and `touched` spare them the work.
struct Contact {
  ContactPlane plane;
  Mask touching;         ///< lanes where the point rests on its plane; set where `touched`
  bool near = false;     ///< a lane has a plane
  bool touched = false;  ///< a lane rests on it
};

/// How much of its freedom along the normal a touching point loses. Not all of it: a link that
/// stands on its contact would have no freedom left, and the system no solution.
inline constexpr float kSlide = 0.98f;

/// A link between two tied points has no freedom: what its system divides by instead. Less than any
/// other has, enough that nothing overflows before it is multiplied by their inverse masses, 0.
inline constexpr float kTiedPivot = 1e-12f;

/// What is left of a point's movement where it may only slide.
HWY_INLINE Vec3 slide(const Contact& contact, const Vec3& move) {
  if (!contact.touched) return move;
  const Vec3& normal = contact.plane.normal;
  return move - select(contact.touching, kSlide * dot(normal, move), Floats(0.0f)) * normal;
}

/// One Newton iteration on all link constraints |x_(i+1) - x_i| = l_i of sixteen strands at once.
///
/// With C the violations, J their gradients (± d_i on the two ends) and W the inverse masses:
///     (J W Jᵀ) lambda = -C,    x += W Jᵀ lambda.
/// A link shares a point with the one before and the one after, so J W Jᵀ is tridiagonal. A point
/// in contact may only slide: its W is w (I - n nᵀ), which keeps the system tridiagonal and lets
/// low stretch and no penetration hold together.
///
/// `inverseMass` [points]: 0 for the root. `lambda` [links] is added to (mass per linear density ·
/// metres): divided by h² it is minus the tension.
HWY_INLINE void correctLinks(std::uint32_t points, const Lanes* linkLength,
                             const Lanes* inverseMass, const Contact* contacts, Floats* lambda,
                             Vec3* x) {
  const std::uint32_t links = points - 1;
  Vec3 d[kMaxGuidePoints];
  Floats above[kMaxGuidePoints], right[kMaxGuidePoints];
  // Thomas, forward sweep. With W_i the inverse mass of point i and d unit, row i is
  //     -c_i lambda_(i-1) + (a_i + b_i) lambda_i - c_(i+1) lambda_(i+1),
  //     a_i = W_i d_i · d_i,  b_i = W_(i+1) d_i · d_i,  c_i = W_i d_(i-1) · d_i;
  // `above` is -c_(i+1) over the pivot. What the root lacks in mass makes its a and c zero.
  Floats pivot = 0.0f, intoBefore = 0.0f;
  for (std::uint32_t i = 0; i < links; ++i) {
    const Vec3 e = x[i + 1] - x[i];
    const Floats lengthNow = max(length(e), Floats(1e-9f));
    d[i] = (Floats(1.0f) / lengthNow) * e;
    Floats a = inverseMass[i], b = inverseMass[i + 1], c = a;
    if (i > 0) {
      Floats turn = dot(d[i - 1], d[i]);
      if (contacts[i].touched) {
        const Floats into =
            select(contacts[i].touching, dot(contacts[i].plane.normal, d[i]), Floats(0.0f));
        turn = turn - kSlide * (intoBefore * into);
        a = a - a * (kSlide * (into * into));
      }
      c = c * turn;
    }
    if (contacts[i + 1].touched) {
      intoBefore =
          select(contacts[i + 1].touching, dot(contacts[i + 1].plane.normal, d[i]), Floats(0.0f));
      b = b - b * (kSlide * (intoBefore * intoBefore));
    }
    Floats diagonal = a + b, rhs = Floats(linkLength[i]) - lengthNow;
    if (i > 0) {
      // Not by way of `above`: each pivot waits for the one before.
      diagonal = diagonal - (c * c) * pivot;
      above[i - 1] = c * pivot;
      rhs = rhs + c * right[i - 1];
    }
    const Floats least = Floats(1e-6f) * Floats(inverseMass[i + 1]);
    pivot = Floats(1.0f) / max(diagonal, max(least, Floats(kTiedPivot)));
    right[i] = rhs * pivot;
  }
  // Backward; what link i and the one after it do to the point between them.
  Floats after = 0.0f;
  Vec3 moveAfter(glm::vec3(0));
  for (std::uint32_t i = links; i-- > 0;) {
    if (i + 1 < links) right[i] = right[i] + above[i] * after;
    after = right[i];
    lambda[i] = lambda[i] + after;
    const Vec3 pull = after * d[i];
    const Vec3 move = slide(contacts[i + 1], pull - moveAfter);
    x[i + 1] = x[i + 1] + Floats(inverseMass[i + 1]) * move;
    moveAfter = pull;
  }
}

/// Root to tip: puts every point at exactly its link's length from the one before, and outside its
/// plane where that is within reach. What Newton has left is a small fraction of a link.
/// `directions` [links]: of the links then, unit.
HWY_INLINE void finishLinks(std::uint32_t points, const Lanes* linkLength,
                            const Lanes* inverseLength, const Contact* contacts, Vec3* x,
                            Vec3* directions) {
  Vec3 start = x[0];
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Floats l = linkLength[i];
    const Vec3 e = x[i + 1] - start;
    // The end first: what follows along the strand waits for it.
    const Vec3 along = (l / max(length(e), Floats(1e-9f))) * e;
    Vec3 end = start + along;
    if (contacts[i + 1].near) {
      const ContactPlane& plane = contacts[i + 1].plane;
      const Mask inside = dot(plane.normal, end) < plane.offset;
      if (any(inside)) {
        // On the circle that the sphere of radius l about x_i cuts out of the plane, the point
        // nearest to where the link points: climb by `rise` along the normal, keep the heading.
        const Floats rise = min(max(plane.offset - dot(plane.normal, start), -l), l);
        const Vec3 direction = Floats(inverseLength[i]) * along;
        const Vec3 flat = direction - dot(direction, plane.normal) * plane.normal;
        const Floats run =
            sqrt(max(l * l - rise * rise, Floats(0.0f))) / max(length(flat), Floats(1e-9f));
        end = select(inside, start + (rise * plane.normal + run * flat), end);
      }
    }
    // Of the points as they were rounded: the next substep sees those, and what is not in both of
    // two strains that it compares would be damped as if it moved.
    directions[i] = Floats(inverseLength[i]) * (end - start);
    x[i + 1] = start = end;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

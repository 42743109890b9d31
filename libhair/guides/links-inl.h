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

/// The contact of a point. `near` and `touched` let the many points without one skip the work.
struct Contact {
  ContactPlane plane;
  Mask touching;         ///< lanes where the point rests on its plane; set where `touched`
  bool near = false;     ///< a lane has a plane
  bool touched = false;  ///< a lane rests on its plane
};

/// The share of its freedom along the normal that a touching point loses. Not all of it: a link
/// at a right angle to its plane could lose all freedom, and make the system singular.
inline constexpr float kSlide = 0.98f;

/// The pivot of a link between two tied points, whose own is 0. Smaller than that of any other
/// link, and large enough that nothing overflows before it is multiplied by the inverse masses, 0.
inline constexpr float kTiedPivot = 1e-12f;

/// Removes the share kSlide of the movement along the normal, in the lanes that touch.
HWY_INLINE Vec3 slide(const Contact& contact, const Vec3& move) {
  if (!contact.touched) return move;
  const Vec3& normal = contact.plane.normal;
  return move - select(contact.touching, kSlide * dot(normal, move), Floats(0.0f)) * normal;
}

/// One Newton iteration on all link constraints |x_(i+1) - x_i| = l_i of sixteen strands at once.
///
/// With C the violations, J their gradients (± d_i on the two ends) and W the inverse masses:
///     (J W Jᵀ) lambda = -C,    x += W Jᵀ lambda.
/// A link shares points with the previous and the next link only, so J W Jᵀ is tridiagonal. A point
/// in contact may only slide: its W is w (I - kSlide n nᵀ). The system stays tridiagonal, and its
/// solution neither stretches links nor pushes points into colliders, to first order.
///
/// `inverseMass` [points]: 0 for the root and tied points. Adds to `lambda` [links] (mass per
/// linear density · metres), which divided by h² is minus the change of tension.
HWY_INLINE void correctLinks(std::uint32_t points, const Lanes* linkLength,
                             const Lanes* inverseMass, const Contact* contacts, Floats* lambda,
                             Vec3* x) {
  const std::uint32_t links = points - 1;
  Vec3 d[kMaxGuidePoints];
  Floats above[kMaxGuidePoints], right[kMaxGuidePoints];
  // Sweep forward (Thomas). With W_i the inverse mass of point i and d unit, row i is
  //     -c_i lambda_(i-1) + (a_i + b_i) lambda_i - c_(i+1) lambda_(i+1),
  //     a_i = W_i d_i · d_i,  b_i = W_(i+1) d_i · d_i,  c_i = W_i d_(i-1) · d_i;
  // `above`[i] is c_(i+1) over the pivot of row i: the entry above the diagonal with its sign
  // turned. The root's inverse mass, 0, makes a_0 zero.
  Floats pivot = 0.0f, intoBefore = 0.0f;
  for (std::uint32_t i = 0; i < links; ++i) {
    const Vec3 e = x[i + 1] - x[i];
    const Floats lengthNow = max(length(e), Floats(1e-9f));
    d[i] = (Floats(1.0f) / lengthNow) * e;
    // Form a, b and c, less along the normals of points in contact.
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
    // Eliminate the entry left of the diagonal.
    Floats diagonal = a + b, rhs = Floats(linkLength[i]) - lengthNow;
    if (i > 0) {
      // Not computed from `above`, to keep the dependency from pivot to pivot short.
      diagonal = diagonal - (c * c) * pivot;
      above[i - 1] = c * pivot;
      rhs = rhs + c * right[i - 1];
    }
    const Floats least = Floats(1e-6f) * Floats(inverseMass[i + 1]);
    pivot = Floats(1.0f) / max(diagonal, max(least, Floats(kTiedPivot)));
    right[i] = rhs * pivot;
  }
  // Sweep back, and move the point between link i and the next by the difference of their pulls.
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

/// Removes the stretch that Newton has left, a small fraction of a link: from root to tip, puts
/// every point at exactly its link's length from the previous point, and out of its plane where a
/// link of this length gets there. `directions` [links]: unit, of the finished links.
HWY_INLINE void finishLinks(std::uint32_t points, const Lanes* linkLength,
                            const Lanes* inverseLength, const Contact* contacts, Vec3* x,
                            Vec3* directions) {
  Vec3 start = x[0];
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Floats l = linkLength[i];
    const Vec3 e = x[i + 1] - start;
    // Scale the link to its length. Compute its end first: the next link depends on it.
    const Vec3 along = (l / max(length(e), Floats(1e-9f))) * e;
    Vec3 end = start + along;
    if (contacts[i + 1].near) {
      const ContactPlane& plane = contacts[i + 1].plane;
      const Mask inside = dot(plane.normal, end) < plane.offset;
      if (any(inside)) {
        // Move an end that penetrates to the nearest point of the circle in which the sphere of
        // radius l about x_i meets the plane: `rise` along the normal, `run` along the plane in the
        // direction of the link.
        const Floats rise = min(max(plane.offset - dot(plane.normal, start), -l), l);
        const Vec3 direction = Floats(inverseLength[i]) * along;
        const Vec3 flat = direction - dot(direction, plane.normal) * plane.normal;
        const Floats run =
            sqrt(max(l * l - rise * rise, Floats(0.0f))) / max(length(flat), Floats(1e-9f));
        end = select(inside, start + (rise * plane.normal + run * flat), end);
      }
    }
    // Take the direction from the rounded points, as the next substep does: damping compares the
    // two strains, and would take a difference in rounding for motion.
    directions[i] = Floats(inverseLength[i]) * (end - start);
    x[i + 1] = start = end;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/guides/guide_strands.h>

namespace hair::literal {

// The steps of the guides' solver as their formulas read: one strand, dense matrices, double, on
// one thread. Slow; the references for tests of the passes that step sixteen strands at once.
// Arguments are not checked.

/// Rest shape of one guide, units as in GuideStrands. Point 0 is the root, which is fixed; no other
/// point is tied. Joint i is at point i, between links i - 1 and i.
struct Guide {
  std::vector<double> mass;           ///< [points], m, per linear density, metres
  std::vector<double> length;         ///< [links], l, metres
  std::vector<double> tension;        ///< [links], at rest, per linear density, m²/s²
  std::vector<double> stiffness;      ///< [links], kappa of joint i, per linear density, m³/s²
  std::vector<glm::dvec3> curvature;  ///< [links], c of joint i, in the frame of link i - 1

  Guide(const GuideStrands& guides, std::size_t guide);
  /// Number of points, the root included.
  std::size_t points() const { return mass.size(); }
  /// Number of links.
  std::size_t links() const { return length.size(); }
};

/// Frame carried along a chain by parallel transport, world space. Unit vectors at a right angle.
struct Frame {
  glm::dvec3 tangent,  ///< towards the tip
      normal;          ///< the binormal is tangent × normal
};

/// The implicit bending step, the system of BendingFactors as a full matrix. With q_i = d_i -
/// d_(i-1) the bend of joint i, linear in the points, q = Q x + const, and D the damping
/// bendDamping / h:
///     (M / h² + (1 + D) Qᵀ kappa Q + S) (y - x) = f - Qᵀ g,
///     g_i = kappa_i (q_i - c_i + D (q_i - q_i before)),    differences in the carried frames.
/// S, u' S u = sum_i T_i |u_(i+1) - u_i|² / l_i, has the rest tensions T_i beyond what an explicit
/// step can apply, m_(i+1) l_i / (4 h²).
/// `x` [points] as predicted, metres; `force` [points], f per linear density, m²/s²; `before`
/// [links], directions before the substep, unit; `root` and `rootBefore`, frames of the root at the
/// end of the substep and before it; `h` and `bendDamping`, seconds. Returns y [points].
std::vector<glm::dvec3> bend(const Guide& guide, const Frame& root, const Frame& rootBefore,
                             std::span<const glm::dvec3> before, std::span<const glm::dvec3> force,
                             double h, double bendDamping, std::span<const glm::dvec3> x);

/// Whether a point rests on a plane, along which it may only slide, and the plane's unit normal.
struct Contact {
  bool touching = false;
  glm::dvec3 normal{0};
};

/// Points after a link step, and what the step did.
struct LinkStep {
  std::vector<double> lambda;  ///< [links], metres · mass per linear density
  std::vector<glm::dvec3> x;   ///< [points], metres
};

/// One Newton iteration on the constraints |x_(i+1) - x_i| = l_i (Bertails et al. 2005, section
/// 4.1: rigid links). With C_i = |x_(i+1) - x_i| - l_i, J its gradients and W the inverse masses:
///     (J W Jᵀ) lambda = -C,    x += W Jᵀ lambda.
/// W_i = (I - 0.98 n nᵀ) / m_i for a point that touches a plane of normal n, I / m_i for others, 0
/// for the root. `contacts` [points]; `x` [points], metres.
LinkStep correctLinks(const Guide& guide, std::span<const Contact> contacts,
                      std::span<const glm::dvec3> x);

/// One sweep of relaxation (van Overveld 1991; Bertails et al. 2005, section 4.1): from root to
/// tip, each link alone takes its length l_i. With d its direction and W as in correctLinks:
///     lambda = (l - |x_(i+1) - x_i|) / (d · (W_i + W_(i+1)) d),
///     x_i -= lambda W_i d,    x_(i+1) += lambda W_(i+1) d.
LinkStep relaxLinks(const Guide& guide, std::span<const Contact> contacts,
                    std::span<const glm::dvec3> x);

}  // namespace hair::literal

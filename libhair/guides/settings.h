#pragma once

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// The method that brings links to their lengths in a substep.
enum class LinkSolver {
  Direct,     ///< all links of a strand at once (Newton), then exact lengths: no stretch
  Relaxation  ///< one link after the other, as in the paper: stretch shrinks with the iterations
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(LinkSolver) {
  return std::array{Word("direct", LinkSolver::Direct), Word("relaxation", LinkSolver::Relaxation)};
}

/// Dynamics of the guide strands. The defaults are those of human hair, stiffened near the root
/// like a groomed wisp; they simulate the paper's hairstyle at interactive rates.
struct GuideSettings {
  float linearDensity = 6.5e-6f;  ///< kg/m, [1e-12, 1); the default is one hair, 80 µm thick
  /// N·m² (E·I) at the root, [0, 1); one bare hair: about 1e-8. 0: a string without stiffness.
  float bendingStiffness = 8e-8f;
  float tipStiffness = 0.35f;  ///< fraction of it at the tip, (0, 1]; linear in between
  float bendDamping = 4e-3f;   ///< seconds, [0, 1); damping torque over stiffness times strain rate
  float airDrag = 8.0f;        ///< 1/s, [0, 1e4); speed relative to the air decays at this rate
  /// Fraction of the head's velocity that the air in its hair has, [0, 1]: a hairdo drags its air
  /// along, and so follows its head. Falls off with the distance (kCarriedAirRadius).
  float carriedAir = 0.7f;
  float friction = 0.3f;            ///< Coulomb's coefficient against colliders, [0, 10]
  float skin = 3e-3f;               ///< metres that guide points keep from colliders, [0, 0.1)
  glm::vec3 gravity{0, -9.81f, 0};  ///< m/s²
  /// Seconds, [1e-5, 0.1]: a frame is cut into equal substeps no longer than this, nor than is
  /// stable (longestSubstep in substeps.h).
  float substep = 1.0f / 480.0f;
  LinkSolver linkSolver = LinkSolver::Direct;  ///< how links keep their lengths
  int iterations = 2;  ///< of the link solver per substep, [1, 32]; relaxation needs 8 or more
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const GuideSettings*) {
  using S = GuideSettings;
  return std::tuple(
      Field("linearDensity", &S::linearDensity, "[1e-12, 1) kg/m"),
      Field("bendingStiffness", &S::bendingStiffness, "[0, 1) N m^2"),
      Field("tipStiffness", &S::tipStiffness, "(0, 1]"),
      Field("bendDamping", &S::bendDamping, "[0, 1) s"),
      Field("airDrag", &S::airDrag, "[0, 1e4) 1/s"), Field("carriedAir", &S::carriedAir, "[0, 1]"),
      Field("friction", &S::friction, "[0, 10]"), Field("skin", &S::skin, "[0, 0.1) m"),
      Field("gravity", &S::gravity, "[0, 1000) m/s^2"),
      Field("substep", &S::substep, "[1e-5, 0.1] s"), Field("linkSolver", &S::linkSolver),
      Field("iterations", &S::iterations, "[1, 32]"));
}

/// Throws Error that names the field and its range.
void validate(const GuideSettings& settings);

}  // namespace hair

#pragma once

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// How links are brought to their lengths in a substep.
enum class LinkSolver {
  Direct,     ///< all links of a strand at once (Newton), then exactly: no stretch
  Relaxation  ///< one after the other, as the paper: stretch shrinks with the iterations
};

/// How guide strands move. The defaults are a human hair's, stiffened near the root as a groomed
/// wisp is; `{}` gives the paper's hairstyle at interactive rate.
struct GuideSettings {
  float linearDensity = 6.5e-6f;  ///< kg/m; of one hair, 80 µm thick
  /// N·m² (E·I) at the root; one bare hair: about 1e-8. 0: a string, which only hangs.
  float bendingStiffness = 8e-8f;
  float tipStiffness = 0.35f;  ///< fraction of it left at the tip, (0, 1]; linear between
  float bendDamping = 4e-3f;   ///< seconds; bending resists its own speed this long, >= 0
  float airDrag = 8.0f;        ///< 1/s; speed relative to the air decays at this rate
  /// How much of the head's own motion the air in its hair has, [0, 1]: hair moves in a volume that
  /// drags its air along, and so follows its head. Less at a distance (kCarriedAirRadius).
  float carriedAir = 0.7f;
  float friction = 0.3f;            ///< Coulomb's coefficient against colliders, >= 0
  float skin = 3e-3f;               ///< metres that guide points keep from colliders, >= 0
  glm::vec3 gravity{0, -9.81f, 0};  ///< m/s²
  float substep = 1.0f / 480.0f;  ///< seconds; a frame is cut into equal steps no longer than this,
                                  ///< or than the shortest joints bear (GuideStrands)
  LinkSolver linkSolver = LinkSolver::Direct;  ///< how links keep their lengths
  int iterations = 2;  ///< of the link solver a substep, 1 to 32; relaxation wants 8 or more
};

/// Throws Error that names the field and its range.
void validate(const GuideSettings& settings);

}  // namespace hair

#pragma once

#include <libhair/guides/guide_strands.h>
#include <libhair/guides/substep_memory.h>

namespace hair {

/// Longest substep of this frame, seconds: the least of settings.substep, the limit of the rest
/// shape (GuideStrands::longestSubstep), and the limits of this frame's motion:
///   - the load on uneven links: gravity, wind and drag, and the rotation of the head;
///   - the roots: they may leave their predicted paths by half of the shortest link, beyond which
///     the predicted direction of a link is useless. No shorter than 1/20000 s, as a jump of the
///     head would need any substep.
/// Throws Error as GuideStrands::longestSubstep.
float longestSubstep(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                     const GuideStrands& guides);

/// Cuts a frame into substeps: interpolates the head, from `from` to motion.worldFromHead, and the
/// colliders at the ends of all substeps, relative to `origin` (metres, world). Fills all of
/// `workspace` but the bending factors and the wind. `skin`: GuideSettings::skin.
void cutFrame(const GuideMotion& motion, glm::vec3 origin, RigidTransform from, float skin,
              std::size_t substeps, SubstepMemory& workspace);

}  // namespace hair

#pragma once

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

// Changes of the scene between two frames. Each preserves the hair's motion as far as possible.
// Call light() afterwards to recompute transmittance and colours without a frame.

/// Teleports hair and head to `worldFromHead`: applies the head's rigid motion to guides, drawn
/// points, capsules, velocities and repulsion, so that the hair keeps its shape and gets no
/// impulse. Forgets planes and meshes: the next frame takes its own as at rest. Gravity and wind
/// stay in world axes. Throws Error for a head that is not finite, or where floats are too coarse
/// (requirePrecision).
void teleport(const RigidTransform& worldFromHead, Hair& hair);

/// Rebases the world to `origin`: later input is relative to it. Hair keeps its shape, velocity and
/// place. Positions are floats, most precise near the origin: programs that travel far should
/// rebase before requirePrecision (guides/validate.h) rejects a frame. Wind gusts and map cells
/// shift with the origin. Throws Error for an origin that is not finite, or too far from the head.
void moveOrigin(glm::vec3 origin, Hair& hair);

/// Replaces the colliders: the next frame treats those of `body` as having been at rest. Guides
/// inside one are moved out without advancing time or changing velocities; guides clear of all keep
/// every bit. frame() does this itself where the number of colliders changes; call it where the
/// number stays and the colliders differ.
/// Throws Error for more than kMaxCapsules capsules, and for colliders that are not valid.
void changeColliders(const BodyState& body, const FrameSettings& settings, Hair& hair);

/// Replaces the groom; it must outlive the hair. If the numbers of guides and of points a guide
/// match, link directions and point velocities are kept with the new link lengths (a trim, or other
/// stiffness, curls or drawn strands, during motion), and it returns true. Otherwise the new guides
/// start at rest on the head. In both cases guides are moved out of colliders as by
/// changeColliders. Time continues.
/// Throws Error as Hair's constructor does; the hair is then unchanged.
bool changeGroom(const Groom& groom, const FrameSettings& settings, Hair& hair);

}  // namespace hair

#pragma once

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

// What may happen to hair between two frames. Each keeps the hair's motion as far as it can; what
// is drawn of a hair that stands still (transmittance, colours) is made again by light().

/// To another place with its head: everything that moves is turned and moved as the head is to get
/// to `worldFromHead`, velocities and the colliders of the frame before included, so that the hair
/// keeps its shape and does not see the jump. Gravity and wind stay the world's. Throws Error for a
/// head that is not finite.
void teleport(const RigidTransform& worldFromHead, Hair& hair);

/// The world's origin moves to `origin`: what is handed over from now on counts from there. Hair
/// keeps its shape, its speed and its place. Positions are floats, which are finest near the
/// origin: who wanders far moves it along now and then, before requirePrecision (guides/validate.h)
/// refuses a frame. Gusts of wind, and cells of the maps, are not where they were. Throws Error for
/// an origin that is not finite.
void moveOrigin(glm::vec3 origin, Hair& hair);

/// Other colliders: the next frame takes those of `body` as having stood where they are now. Guides
/// that are inside one are brought out, in no time and without a change of their velocities; guides
/// that are clear of all keep every bit. frame() does this by itself where the body has more or
/// fewer colliders than before; where as many others take their places, it must be told.
/// Throws Error for more than kMaxCapsules capsules, and for colliders that are not valid.
void changeColliders(const BodyState& body, const FrameSettings& settings, Hair& hair);

/// Another hairstyle on the same head, from now on: `groom` must outlive the hair. Where it has as
/// many guides, of as many points, as the one before, the directions and velocities of all links
/// stay and their lengths are the new ones (a trim, or other stiffness, curls or drawn strands, in
/// the middle of a motion): returns true. Otherwise the new guides are at rest where the head is.
/// Both are brought out of colliders as changeColliders does. Time goes on.
/// Throws Error as Hair's constructor does; the hair then is as it was.
bool changeGroom(const Groom& groom, const FrameSettings& settings, Hair& hair);

}  // namespace hair

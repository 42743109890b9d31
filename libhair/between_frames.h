#pragma once

#include <libhair/frame.h>

namespace hair {

/// What may happen to hair between two frames. Each keeps the hair's motion as far as it can; what
/// is drawn of a hair that stands still (transmittance, colours) is made again by light().

/// To another place with its head: everything that moves is turned and moved as the head is to get
/// to `worldFromHead`, velocities and the colliders of the frame before included, so that the hair
/// keeps its shape and does not see the jump. Gravity and wind stay the world's.
void teleport(const RigidTransform& worldFromHead, Hair& hair);

/// Other colliders: the next frame takes those of `body` as having stood where they are now. Guides
/// that are inside one are brought out, in no time and without a change of their velocities; guides
/// that are clear of all keep every bit. frame() does this by itself where the body has more or
/// fewer colliders than before; where as many others take their places, it must be told.
/// Throws Error for more than kMaxCapsules capsules.
void changeColliders(const BodyState& body, const FrameSettings& settings, Hair& hair);

/// Another hairstyle on the same head, from now on: `groom` must outlive the hair. Where it has as
/// many guides, of as many points, as the one before, the directions and velocities of all links
/// stay and their lengths are the new ones (a trim, or other stiffness, curls or drawn strands, in
/// the middle of a motion): returns true. Otherwise the new guides are at rest where the head is.
/// Both are brought out of colliders as changeColliders does. Time goes on.
/// Throws Error as Hair's constructor does; the hair then is as it was.
bool changeGroom(const Groom& groom, const FrameSettings& settings, Hair& hair);

}  // namespace hair

#pragma once

#include <span>

#include <libhair/motion/body.h>
#include <libhair/motion/joint_names.h>

namespace hair {

/// Which joint is which part of a body, told by what hangs on what: two pairs of limbs of the same
/// bones, the legs where the root is and the arms above, and a neck between the arms. Left is where
/// names say so, or else left of where the toes point and the knees bend in the clip. Needs no unit
/// and no axes. Not complete() where the skeleton is no human's.
BodyMap mapByStructure(const Clip& clip, std::span<const JointName> names);

/// Fills in what follows from hands, feet and head: elbows and shoulders, knees and hips, chest,
/// neck and spine, by what hangs on what.
void mapBetween(const Skeleton& skeleton, std::span<const JointName> names, BodyMap& map);

/// Whether a complete map may be a person: its joints differ, no limb is without length, both sides
/// are about as long.
bool mayBePerson(const Skeleton& skeleton, const BodyMap& map);

/// Length along the bones from a joint down to one below it, the file's unit; 0 where it is not.
float boneLength(const Skeleton& skeleton, int from, int to);

}  // namespace hair

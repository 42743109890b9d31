#pragma once

#include <glm/gtc/quaternion.hpp>

#include <libhair/motion/body.h>

namespace hair {

/// The turn of a clip into +Y up; not for Recognised.
glm::quat uprightFromClip(ClipUp up);

/// Size of a skeleton against that of a person of 1.68 m, by its bones from ankles to head, in the
/// unit of the skeleton; 0 where the map is not complete.
float sizeOf(const Skeleton& skeleton, const BodyMap& map);
/// Height of a person with such bones, in the unit of the skeleton.
float statureOf(const Skeleton& skeleton, const BodyMap& map);

/// Metres per unit that make a person of a skeleton: the usual unit in which it is as tall as
/// people are (metres, centimetres, millimetres, inches, feet, decimetres, the 5.64 cm of many
/// conversions of CMU's library); where there is none, what makes it 1.7 m. 0.01 where the skeleton
/// is no person's.
float unitOf(const Skeleton& skeleton, const BodyMap& map);

/// The axis along which the body stands: how upright it is in the clip and at its start, whether
/// its lowest joints keep to a floor at zero, where the skeleton's zero pose stands; +Y where that
/// does not tell. A clip that lies or crawls from end to end on a floor at y = 0 is +Y up. `clip`
/// in metres of any axes.
ClipUp upOf(const Clip& clip, const BodyMap& map);

/// Turns the roots of a clip, so that `up` is +Y.
void makeUpright(Clip& clip, ClipUp up);

}  // namespace hair

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

/// What the name of a joint says.
struct JointName {
  std::string part;  ///< lower-case letters and digits, without namespace, common prefix and side
  int side = -1;     ///< 0 left, 1 right, -1 neither
};

/// Names of the joints of one skeleton. Sides are words before, after or in the middle of a name
/// (LeftArm, l_arm, arm.L, Bip01 L Arm), or the letter in which two names differ (larm, rarm).
std::vector<JointName> jointNames(std::span<const std::string> names);

/// Parts of a body that names tell.
enum class NamedPart { Head, Hand, Foot, Eye };

/// How well a name fits: 0 not at all; more, the more of the name the word for it is. Fingers are
/// no hands, nor are twist bones, props, ends of bones and targets of inverse kinematics.
int likeness(const JointName& name, NamedPart part);

/// Whether a joint only shares in the turn of its parent: twist and roll bones, and the further
/// pieces of a bone that is cut in pieces (upper_arm, upper_arm.001).
bool isTwist(const JointName& name, const JointName& parent);

}  // namespace hair

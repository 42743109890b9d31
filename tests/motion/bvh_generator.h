#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace hair::test {

/// What the person of the generator does, all of it in two seconds.
enum class Act { Walk, Bow, LieDown, Crawl };
inline constexpr int kActCount = 4;

/// Which way the frames of joints are turned, and so what the pose with all angles zero looks like.
enum class Rig {
  T,         ///< arms straight out; frames as the world's
  A,         ///< arms 45 degrees down
  ArmsDown,  ///< arms at the sides
  XBones,    ///< bones along X, as Maya's: the zero pose is a knot
  Turned,    ///< frames turned by right angles at random: another knot
  Lying,     ///< a T that lies on its back
  Tilted,    ///< a T turned by odd angles as a whole
};
inline constexpr int kRigCount = 7;

/// How one clip of one person is written down.
struct Spelling {
  std::string what;     ///< for messages
  Act act = Act::Walk;  ///< what is done
  double unit = 0.01;   ///< metres
  int up = 1;           ///< axis of the file that points up: 0..2 +X +Y +Z, 3..5 their opposites
  bool rigStandsSo = false;  ///< the rig's zero pose stands along that axis too
  double yaw = 0;            ///< degrees about it
  Rig rig = Rig::T;
  int names = 0;           ///< of kNameCount
  std::uint32_t seed = 0;  ///< of random choices: Turned
  int rotationOrder = 0;   ///< 0: ZXY, then the five others
  bool rootAbove = false;  ///< a joint at the origin above the hips
  bool fingers = false, eyes = false, twists = false, targets = false, hairBones = false,
       toes = false;
  bool moreSpine = false;  ///< spine and neck of two joints each more
  bool noNeck = false, noTips = false;
  enum class Positions { Root, Absolute, Added, ZeroOffsets } positions = Positions::Root;
  enum class Text {
    Plain,
    LowerCase,
    Wrapped,
    Tabs,
    CrLf,
    Bom,
    OneMoreRow,
    TextAfter,
    ControlZ,
    NamedEnds,
    EndChannels,
    Comments,
    OneLine,
    Rate,
    Milliseconds
  } text = Text::Plain;
};
inline constexpr int kNameCount = 17, kTextCount = 15;
/// Names of the last ones tell nothing, or are in another language.
inline constexpr int kTellingNames = 14;

/// The person in one frame, by plain forward kinematics in double precision: metres, +Y up.
struct PersonPose {
  std::vector<glm::dvec3> places;  ///< [kParts]
  std::vector<glm::dquat> turns;   ///< [kParts], from the T pose
  glm::dvec3 headUp, headFront;    ///< unit
};

/// Parts of the person, in the order of PersonPose::places.
enum Part {
  kHips,
  kSpine,
  kChest,
  kNeck,
  kHead,
  kLeftCollar,
  kLeftShoulder,
  kLeftElbow,
  kLeftWrist,
  kRightCollar,
  kRightShoulder,
  kRightElbow,
  kRightWrist,
  kLeftHip,
  kLeftKnee,
  kLeftAnkle,
  kRightHip,
  kRightKnee,
  kRightAnkle,
  kParts
};

inline constexpr int kFrames = 40;
/// Of the person's size: heights of people are guessed for units that nobody uses.
inline constexpr double kStature = 1.706;

PersonPose poseOf(Act act, int frame);
/// The file.
std::string bvhOf(const Spelling& spelling);
/// Name of a part in a spelling.
std::string nameOf(const Spelling& spelling, Part part);

}  // namespace hair::test

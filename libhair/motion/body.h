#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/core/transform.h>
#include <libhair/motion/motion.h>

namespace hair {

/// Which joint is which part of a human body; -1: not found. Sides: 0 left, 1 right.
struct BodyMap {
  int hips = -1,           ///< where the legs part
      chest = -1,          ///< that the arms hang on
      neck = -1,           ///< below the head
      head = -1;           ///< that the head turns on
  std::vector<int> spine;  ///< from below the hips' child up to the chest, chest included
  std::array<int, 2> collar{-1, -1},  ///< between chest and arm
      upperArm{-1, -1},               ///< shoulder
      foreArm{-1, -1},                ///< elbow
      hand{-1, -1};                   ///< wrist
  std::array<int, 2> thigh{-1, -1},   ///< hip joint
      shin{-1, -1},                   ///< knee
      foot{-1, -1};                   ///< ankle

  /// All that a torso, two arms and two legs need.
  bool complete() const;
};

/// A capsule that moves with joints: `a` is fixed in the frame of jointA, `b` in that of jointB.
struct BodyCapsule {
  int jointA,           ///< that carries a
      jointB;           ///< that carries b
  glm::vec3 a,          ///< in the frame of jointA, metres
      b;                ///< in the frame of jointB, metres
  float radius;         ///< metres
  bool yields = false;  ///< gets thinner where it presses against head or trunk: makeRoomForHair
};

/// Who moves: a skeleton, what its joints mean, and where its flesh is.
///
/// *Body space*: metres, +Y up, +Z where the body faces, +X to its left, origin between the feet.
/// *Rest stance*: upright, legs straight down, arms straight out to the sides (a T).
struct Body {
  Skeleton skeleton;  ///< the joints, with lengths of bones
  BodyMap map;        ///< which of them is what
  /// [jointCount], bodyFromJoint in the rest stance, whatever the skeleton's own zero pose is.
  std::vector<RigidTransform> rest;
  /// Constant turn from head space (see Groom: +Y up, +Z face) to the frame of joint map.head.
  RigidTransform jointFromHead;
  float size = 1.0f;                  ///< against a person of 1.68 m
  std::vector<BodyCapsule> capsules;  ///< see body_colliders.h
  std::vector<std::string> notes;     ///< what had to be guessed, for the user
};

/// Joints by name, in any convention (LeftArm, lShldr, mixamorig:LeftArm, Bip01 L UpperArm, arm.L
/// ...): hands, feet and head by name, the rest by what hangs on what.
BodyMap mapBody(const Skeleton& skeleton);

/// The same, and all by what hangs on what where names do not tell. `headJoint`: the name of the
/// joint that the head turns on; empty: found. Throws Error with the joints there are where none is
/// called so.
BodyMap mapBody(const Clip& clip, std::string_view headJoint);

/// The names of the joints, for a message.
std::string jointList(const Skeleton& skeleton);

/// The body of a clip in metres, +Y up. Where its zero pose stands, which way each joint faces is
/// told by that; else by the bones (rest_stance.h). `headJoint` as mapBody has it. Throws Error
/// where there is no joint that may be a head.
Body makeBody(const Clip& clip, std::string_view headJoint = {});

}  // namespace hair

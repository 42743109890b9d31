#pragma once

#include <cstddef>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/geometry/colliders.h>
#include <libhair/motion/body.h>
#include <libhair/motion/clip_filter.h>
#include <libhair/motion/skeleton.h>

namespace HAIR_API hair {

/// The pose of a body, as a frame needs it.
struct BodyPose {
  RigidTransform worldFromHead;                ///< head space: see Groom
  std::vector<Capsule> capsules;               ///< same count and order at every time
  std::vector<RigidTransform> worldFromJoint;  ///< [jointCount], to draw the body
};

/// The part of a clip that is used, and its repairs.
struct MotionSettings {
  bool dropLeadIn = true;      ///< drop a calibration pose at the start (leadInFrames)
  std::size_t firstFrame = 0;  ///< of the clip as it comes; > 0 instead of dropLeadIn
  std::size_t lastFrame = 0;   ///< one past the last; 0: to the end
  bool removeFlips = true;     ///< joints that jump for a frame or two (hair::removeFlips)
  FlipSettings flips;          ///< what counts as one
};

/// A moving body: a recorded clip, the built-in dance, or a body that stands still.
class Motion {
 public:
  /// Throws Error for a clip without frames, or frames that it does not have.
  explicit Motion(Clip clip, const MotionSettings& settings = {});
  /// The built-in dance, which loops.
  static Motion dance();
  /// A body that stands still.
  static Motion still();

  /// Seconds; 0: never moves. Later times hold the last pose, negative ones the first; a loop
  /// (isLoop) wraps around instead.
  double duration() const { return clip_.duration(); }
  /// Whether time wraps around after duration().
  bool isLoop() const { return loop_; }

  /// The pose at a time.
  BodyPose pose(double seconds) const;
  /// No allocation where `out` comes from an earlier call.
  void pose(double seconds, BodyPose& out) const;

  /// Height of the floor, metres: below the lowest capsule in all but a tenth of the frames (leaps
  /// leave the floor, errors of the recording penetrate it).
  float floorHeight() const { return floorHeight_; }

  /// The body.
  const Body& body() const { return body_; }
  /// The clip that is played: without dropped frames and flips.
  const Clip& clip() const { return clip_; }
  /// Number of frames dropped at the start of the original clip.
  std::size_t droppedFrames() const { return droppedFrames_; }
  const std::vector<Flip>& flips() const { return flips_; }  ///< frames of clip()

 private:
  Clip clip_;
  Body body_;
  std::vector<Flip> flips_;
  std::size_t droppedFrames_ = 0;
  float floorHeight_ = 0;
  bool loop_ = false;
};

}  // namespace hair

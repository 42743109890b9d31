#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>

namespace HAIR_API hair {

struct Bvh;

/// A tree of joints; a parent stands before its children.
struct Skeleton {
  std::vector<std::string> names;  ///< [jointCount]
  std::vector<int> parents;        ///< [jointCount], -1: a root
  std::vector<glm::vec3> offsets;  ///< [jointCount], from the parent, in its frame, metres
  /// [jointCount], from the joint to where its last bone ends ("End Site"), in its own frame,
  /// metres; zero where a joint has none.
  std::vector<glm::vec3> tips;

  /// How many joints there are.
  std::size_t jointCount() const { return parents.size(); }
};

/// A recorded motion: joint rotations and positions relative to the parent, frame by frame.
struct Clip {
  Skeleton skeleton;                 ///< whose joints these are
  double frameTime = 1.0 / 120.0;    ///< seconds, > 0
  std::vector<glm::quat> rotations;  ///< [frameCount · jointCount], joints of a frame together
  std::vector<glm::vec3> positions;  ///< [frameCount · jointCount], in the parent, metres

  /// How many frames there are.
  std::size_t frameCount() const {
    return skeleton.jointCount() ? rotations.size() / skeleton.jointCount() : 0;
  }
  /// Seconds from the first frame to the last.
  double duration() const {
    return frameCount() ? static_cast<double>(frameCount() - 1) * frameTime : 0.0;
  }
};

/// Any order of axes, any channels. Position channels stand for the joint's place in its parent and
/// so replace the offset (as mocap tools write them), on any joint; below the root they are added
/// to it where most of them are nearer to zero than to the offset. Bones whose offset is not where
/// the positions put their joint (many programs leave zeros there) are as long as the positions
/// say. `scale` turns the file's unit into metres (most files: centimetres). Throws Error for a
/// clip without joints or frames, and for joints beyond 1000 km of their parents.
Clip clipFromBvh(const Bvh& bvh, float scale = 0.01f);

/// Forward kinematics of one frame: worldFromJoint, [jointCount].
void poseAtFrame(const Clip& clip, std::size_t frame, std::span<RigidTransform> worldFromJoint);

/// The same between frames: rotations along the shortest arc, positions on the Catmull-Rom curve
/// through the frames. Times outside the clip hold its first or last frame.
void poseAtTime(const Clip& clip, double seconds, std::span<RigidTransform> worldFromJoint);

/// The clip at another frame time; the same frame time gives the same clip, bit for bit.
Clip resample(const Clip& clip, double frameTime);

/// Frames [first, last) of the clip.
Clip trim(const Clip& clip, std::size_t first, std::size_t last);

/// How many frames to drop at the start: recordings often open with a calibration pose from which
/// the first frames jump (CMU: 5). 0 where the clip starts as it goes on.
std::size_t leadInFrames(const Clip& clip);

struct Body;

/// The pose of a body, as a frame needs it.
struct BodyPose {
  RigidTransform worldFromHead;                ///< head space: see Groom
  std::vector<Capsule> capsules;               ///< same count and order at every time
  std::vector<RigidTransform> worldFromJoint;  ///< [jointCount], to draw the body
};

/// What counts as a flip.
struct FlipSettings {
  float minDegrees = 1.2f;  ///< a jump smaller than this is never a flip
  float ratio = 3.0f;       ///< how far it must stand out against the motion around it
  int maxFrames = 2;        ///< longest flip, frames
};

/// A joint that for one or two frames jumped away and came back.
struct Flip {
  std::size_t joint;  ///< that jumped
  std::size_t frame;  ///< first bad frame
  int frames;         ///< how many
  float degrees;      ///< from where the joint should have been
};

/// Which axis of a clip points up.
enum class ClipUp : std::uint8_t {
  Recognised,  ///< by how the body stands
  X,           ///< +X
  Y,           ///< +Y
  Z,           ///< +Z
  XDown,       ///< -X
  YDown,       ///< -Y
  ZDown,       ///< -Z
};

/// `x`, `y`, `z`, `x-down`, `y-down`, `z-down`, also `+Y`, `-Z`, `z-back` ...; any case. Throws
/// Error with the choices.
ClipUp clipUpFromText(std::string_view text);
/// For people: "+Y", "-Z".
std::string_view clipUpText(ClipUp up);

/// How a clip is understood, the part of it that is used, and its repairs.
struct MotionSettings {
  float scale = 0;                 ///< metres per unit of a Bvh; 0: recognised by the bones
  ClipUp up = ClipUp::Recognised;  ///< axis of a Bvh that points up
  std::string headJoint;           ///< name of the joint that the head turns on; empty: found
  bool dropLeadIn = true;          ///< drop a calibration pose at the start (leadInFrames)
  std::size_t firstFrame = 0;      ///< of the clip as it comes; > 0 instead of dropLeadIn
  std::size_t lastFrame = 0;       ///< one past the last; 0: to the end
  bool removeFlips = true;         ///< joints that jump for a frame or two (hair::removeFlips)
  FlipSettings flips;              ///< what counts as one
};

/// A moving body: a recorded clip, the built-in dance, or a body that stands still.
class Motion {
 public:
  /// A clip in metres, +Y up. Throws Error for a clip without frames, or frames that it does not
  /// have.
  explicit Motion(Clip clip, const MotionSettings& settings = {});
  /// What a file holds, in whatever unit and axes, which are recognised from the body where the
  /// settings do not say them: see notes(). Throws Error as clipFromBvh does.
  explicit Motion(const Bvh& bvh, const MotionSettings& settings = {});
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

  /// Its skeleton, flesh and rest stance, for BodyMesh.
  const Body& body() const { return *body_; }
  /// The clip that is played: without dropped frames and flips.
  const Clip& clip() const { return clip_; }
  /// Number of frames dropped at the start of the original clip.
  std::size_t droppedFrames() const { return droppedFrames_; }
  const std::vector<Flip>& flips() const { return flips_; }  ///< frames of clip()

  /// "1.72 m tall, 0.01 m per unit, +Y up, head joint Head"; units and axes of a Bvh only.
  std::string person() const;
  /// What the user should know, a line each, the most important first: who was recognised, what
  /// cannot be or was repaired, in sum. Empty for the built-in dance.
  std::vector<std::string> notes() const;
  /// Each repair by itself, and how the body was understood.
  std::vector<std::string> details() const;

 private:
  Clip clip_;
  std::shared_ptr<const Body> body_;
  std::vector<Flip> flips_;
  std::size_t droppedFrames_ = 0;
  float floorHeight_ = 0;
  bool loop_ = false;

  /// Of the file, if it comes from one.
  struct Source {
    float scale;                     ///< metres per unit
    float recognisedScale;           ///< that would make a person of it
    ClipUp up;                       ///< axis of the file that points up
    std::vector<std::string> notes;  ///< Bvh::notes
  };
  std::optional<Source> source_;
};

}  // namespace hair

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>

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

/// Any order of axes, any channels; position channels stand for the joint's place in its parent and
/// so replace the offset (as mocap tools write them), on any joint. `scale` turns the file's unit
/// into metres (most files: centimetres). Throws Error for a clip without joints or frames, and for
/// joints beyond 1000 km of their parents.
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

}  // namespace hair

#include <libhair/motion/motion.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/motion/body.h>
#include <libhair/motion/body_colliders.h>
#include <libhair/motion/clip_filter.h>
#include <libhair/motion/clip_units.h>
#include <libhair/motion/dance.h>
#include <libhair/motion/head_motion.h>
#include <libhair/motion/person_frame.h>

namespace hair {
namespace {

/// Settings without repairs, for clips that are generated, not recorded.
MotionSettings asAuthored() {
  MotionSettings settings;
  settings.dropLeadIn = settings.removeFlips = false;
  return settings;
}

}  // namespace

Motion::Motion(Clip clip, const MotionSettings& settings) {
  require(clip.frameCount() > 0, "motion: the clip has no frames");
  const std::size_t last = settings.lastFrame == 0 ? clip.frameCount() : settings.lastFrame;
  droppedFrames_ = settings.firstFrame;
  if (settings.firstFrame == 0 && settings.dropLeadIn) droppedFrames_ = leadInFrames(clip);
  require(droppedFrames_ < last && last <= clip.frameCount(), "motion: frames ", droppedFrames_,
          " to ", last, " of a clip of ", clip.frameCount(), " frames; set firstFrame, lastFrame");
  clip_ = droppedFrames_ == 0 && last == clip.frameCount() ? std::move(clip)
                                                           : trim(clip, droppedFrames_, last);
  if (settings.removeFlips) flips_ = hair::removeFlips(clip_, settings.flips);
  body_ = std::make_shared<const Body>(makeBody(clip_, settings.headJoint));

  if (body_->capsules.empty()) return;
  BodyPose at;
  std::vector<float> lowest;
  const std::size_t step = clip_.frameCount() / 300 + 1;
  for (std::size_t f = 0; f < clip_.frameCount(); f += step) {
    pose(static_cast<double>(f) * clip_.frameTime, at);
    lowest.push_back(INFINITY);
    for (const Capsule& c : at.capsules)
      lowest.back() = std::min(lowest.back(), std::min(c.a.y, c.b.y) - c.radius);
  }
  const auto tenth = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 10);
  std::nth_element(lowest.begin(), tenth, lowest.end());
  floorHeight_ = *tenth;
}

Motion::Motion(const Bvh& bvh, const MotionSettings& settings) {
  Clip clip = clipInFileUnits(bvh);
  const BodyMap map = mapBody(clip, settings.headJoint);
  Source source{settings.scale, unitOf(clip.skeleton, map), settings.up, bvh.notes};
  if (!(source.scale > 0)) source.scale = source.recognisedScale;
  toMetres(clip, source.scale);
  if (source.up == ClipUp::Recognised) source.up = upOf(clip, map);
  makeUpright(clip, source.up);
  *this = Motion(std::move(clip), settings);
  source_ = std::move(source);
}

Motion Motion::dance() {
  Motion motion(danceClip(), asAuthored());
  motion.loop_ = true;
  return motion;
}

Motion Motion::still() {
  return Motion(stillClip(), asAuthored());
}

BodyPose Motion::pose(double seconds) const {
  BodyPose out;
  pose(seconds, out);
  return out;
}

void Motion::pose(double seconds, BodyPose& out) const {
  if (loop_ && duration() > 0) seconds -= std::floor(seconds / duration()) * duration();
  out.worldFromJoint.resize(clip_.skeleton.jointCount());
  out.capsules.resize(body_->capsules.size());
  poseAtTime(clip_, seconds, out.worldFromJoint);
  out.worldFromHead = worldFromHead(*body_, out.worldFromJoint);
  placeCapsules(*body_, out.worldFromJoint, out.capsules);
  makeRoomForHair(*body_, out.worldFromHead, out.capsules);
}

}  // namespace hair

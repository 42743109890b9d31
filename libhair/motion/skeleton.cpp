#include <libhair/motion/motion.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>

namespace hair {
namespace {

void chain(const Skeleton& skeleton, std::span<RigidTransform> worldFromJoint) {
  for (std::size_t j = 0; j < skeleton.jointCount(); ++j) {
    const int parent = skeleton.parents[j];
    if (parent >= 0)
      worldFromJoint[j] = worldFromJoint[static_cast<std::size_t>(parent)] * worldFromJoint[j];
  }
}

/// One joint between frames, in its parent.
RigidTransform localAt(const Clip& clip, std::size_t joint, std::size_t frame, float t) {
  const std::size_t joints = clip.skeleton.jointCount();
  const std::size_t i = frame * joints + joint;
  if (t == 0.0f) return {clip.rotations[i], clip.positions[i]};
  const std::size_t last = clip.frameCount() - 1;
  const glm::vec3 p1 = clip.positions[i];
  const glm::vec3 p2 = clip.positions[i + joints];
  const glm::vec3 p0 = frame > 0 ? clip.positions[i - joints] : 2.0f * p1 - p2;
  const glm::vec3 p3 = frame + 2 <= last ? clip.positions[i + 2 * joints] : 2.0f * p2 - p1;
  const glm::vec3 position = p1 + 0.5f * t *
                                      ((p2 - p0) + t * ((2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3) +
                                                        t * (3.0f * (p1 - p2) + p3 - p0)));
  return {glm::normalize(glm::slerp(clip.rotations[i], clip.rotations[i + joints], t)), position};
}

struct FrameTime {
  std::size_t frame;
  float t;  ///< [0, 1) towards the next frame; 0 on the last
};

FrameTime frameTimeAt(const Clip& clip, double seconds) {
  const std::size_t last = clip.frameCount() - 1;
  const double f = std::clamp(seconds / clip.frameTime, 0.0, static_cast<double>(last));
  // Snap to a frame's own time, which rounding may have missed.
  const double nearest = std::round(f);
  if (std::abs(f - nearest) < 1e-6) return {static_cast<std::size_t>(nearest), 0.0f};
  const double whole = std::floor(f);
  return {static_cast<std::size_t>(whole), static_cast<float>(f - whole)};
}

}  // namespace

void poseAtFrame(const Clip& clip, std::size_t frame, std::span<RigidTransform> worldFromJoint) {
  for (std::size_t j = 0; j < clip.skeleton.jointCount(); ++j)
    worldFromJoint[j] = localAt(clip, j, frame, 0.0f);
  chain(clip.skeleton, worldFromJoint);
}

void poseAtTime(const Clip& clip, double seconds, std::span<RigidTransform> worldFromJoint) {
  const FrameTime at = frameTimeAt(clip, seconds);
  for (std::size_t j = 0; j < clip.skeleton.jointCount(); ++j)
    worldFromJoint[j] = localAt(clip, j, at.frame, at.t);
  chain(clip.skeleton, worldFromJoint);
}

Clip resample(const Clip& clip, double frameTime) {
  require(frameTime > 0 && std::isfinite(frameTime), "resample: frame time ", frameTime,
          " s, must be above 0");
  require(clip.frameCount() > 0, "resample: the clip has no frames");
  Clip out;
  out.skeleton = clip.skeleton;
  out.frameTime = frameTime;
  // One more frame than intervals; the tolerance keeps a last one that rounding would lose.
  const std::size_t frames = 1 + static_cast<std::size_t>(clip.duration() / frameTime + 1e-6);
  out.rotations.reserve(frames * clip.skeleton.jointCount());
  out.positions.reserve(frames * clip.skeleton.jointCount());
  for (std::size_t f = 0; f < frames; ++f) {
    const FrameTime at = frameTimeAt(clip, static_cast<double>(f) * frameTime);
    for (std::size_t j = 0; j < clip.skeleton.jointCount(); ++j) {
      const RigidTransform local = localAt(clip, j, at.frame, at.t);
      out.rotations.push_back(local.rotation);
      out.positions.push_back(local.translation);
    }
  }
  return out;
}

Clip trim(const Clip& clip, std::size_t first, std::size_t last) {
  require(first < last && last <= clip.frameCount(), "trim: frames ", first, " to ", last,
          " of a clip of ", clip.frameCount(), " frames");
  const std::size_t joints = clip.skeleton.jointCount();
  const auto part = [&](const auto& values) {
    const auto begin = values.begin();
    return std::vector(begin + static_cast<std::ptrdiff_t>(first * joints),
                       begin + static_cast<std::ptrdiff_t>(last * joints));
  };
  return {clip.skeleton, clip.frameTime, part(clip.rotations), part(clip.positions)};
}

std::size_t leadInFrames(const Clip& clip) {
  // Steps between frames: the mean over joints of how far they turn. One joint may spin fast, but
  // when a recording jumps, the whole body does.
  constexpr std::size_t kSearched = 12, kCompared = 36;
  if (clip.frameCount() < kSearched + 12) return 0;
  const std::size_t joints = clip.skeleton.jointCount();
  const std::size_t steps = std::min(kCompared, clip.frameCount() - 1);
  std::vector<float> turned(steps);
  for (std::size_t f = 0; f < steps; ++f) {
    float sum = 0;
    for (std::size_t j = 0; j < joints; ++j)
      sum += degreesBetween(clip.rotations[f * joints + j], clip.rotations[(f + 1) * joints + j]);
    turned[f] = sum / static_cast<float>(joints);
  }
  std::vector<float> usual(turned.begin() + kSearched, turned.end());
  const auto middle = usual.begin() + static_cast<std::ptrdiff_t>(usual.size() / 2);
  std::nth_element(usual.begin(), middle, usual.end());
  if (turned[0] < std::max(1.0f, 4.0f * *middle)) return 0;
  std::size_t drop = 1;
  while (drop < kSearched && turned[drop] > std::max(0.5f, 1.5f * *middle)) ++drop;
  return drop;
}

}  // namespace hair

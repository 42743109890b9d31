#include <libhair/motion/clip_filter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/rotations.h>

namespace hair {
namespace {

/// One joint's rotations over the clip.
class Track {
 public:
  Track(Clip& clip, std::size_t joint) : clip_(clip), joint_(joint) {}
  glm::quat& operator[](std::ptrdiff_t f) {
    return clip_.rotations[static_cast<std::size_t>(f) * clip_.skeleton.jointCount() + joint_];
  }
  std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(clip_.frameCount()); }

  /// Deviation of frame f from the interpolation of frames a and b: rotation vector, degrees.
  glm::vec3 off(std::ptrdiff_t a, std::ptrdiff_t f, std::ptrdiff_t b) {
    glm::quat d = glm::conjugate(between(a, f, b)) * (*this)[f];
    if (d.w < 0) d = -d;
    const glm::vec3 v(d.x, d.y, d.z);
    const float sine = glm::length(v);
    return sine > 0 ? v * (glm::degrees(2.0f * std::atan2(sine, d.w)) / sine) : glm::vec3(0);
  }
  glm::quat between(std::ptrdiff_t a, std::ptrdiff_t f, std::ptrdiff_t b) {
    return glm::normalize(
        glm::slerp((*this)[a], (*this)[b], static_cast<float>(f - a) / static_cast<float>(b - a)));
  }

 private:
  Clip& clip_;
  std::size_t joint_;
};

/// Curvature of the path around frames [f, f + n), excluding them: median deviation of frames from
/// their neighbours' interpolation, which is robust against another flip nearby. Smooth motion of
/// any speed is nearly linear over three frames.
float crookedness(Track& track, std::ptrdiff_t f, std::ptrdiff_t n) {
  std::array<float, 6> off{};
  std::size_t count = 0;
  for (std::ptrdiff_t d = 2; d <= 4; ++d) {
    if (f - d >= 1) off[count++] = glm::length(track.off(f - d - 1, f - d, f - d + 1));
    const std::ptrdiff_t i = f + n - 1 + d;
    if (i + 1 < track.size()) off[count++] = glm::length(track.off(i - 1, i, i + 1));
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(off.begin(), middle, off.begin() + static_cast<std::ptrdiff_t>(count));
  return count > 0 ? *middle : 0.0f;
}

}  // namespace

std::vector<Flip> removeFlips(Clip& clip, const FlipSettings& settings) {
  std::vector<Flip> flips;
  for (std::size_t joint = 0; joint < clip.skeleton.jointCount(); ++joint) {
    Track track(clip, joint);
    // Short flips first: a long window over a short flip would also replace good frames.
    for (std::ptrdiff_t n = 1; n <= settings.maxFrames; ++n) {
      for (std::ptrdiff_t f = 2; f + n + 1 < track.size(); ++f) {
        const std::ptrdiff_t before = f - 1, after = f + n;
        const glm::vec3 bump = track.off(before, f, after);
        float least = glm::length(bump), most = least;
        for (std::ptrdiff_t i = f + 1; i < after; ++i) {
          const glm::vec3 off = track.off(before, i, after);
          // All of it on the same side.
          least = std::min(least, glm::dot(off, glm::normalize(bump)));
          most = std::max(most, glm::length(off));
        }
        if (least < settings.minDegrees) continue;
        // A flip leaves the path and returns: on both sides the path bends towards the bump. A
        // sharp turn or a lasting jump bends on one side only.
        const glm::vec3 side = glm::normalize(bump);
        const auto bends = [&](std::ptrdiff_t i) {
          return -glm::dot(track.off(i - 1, i, i + 1), side);
        };
        if (bends(before) < 0.25f * least || bends(after) < 0.25f * least) continue;
        // Second differences grow with the square of the number of frames.
        const float scale = 0.25f * static_cast<float>((n + 1) * (n + 1));
        if (least < settings.ratio * scale * crookedness(track, f, n)) continue;
        for (std::ptrdiff_t i = f; i < after; ++i) {
          // Only what lies strictly between is read: frames before and after are good.
          track[i] = track.between(before, i, after);
        }
        flips.push_back({joint, static_cast<std::size_t>(f), static_cast<int>(n), most});
      }
    }
  }
  std::sort(flips.begin(), flips.end(), [](const Flip& a, const Flip& b) {
    return a.frame != b.frame ? a.frame < b.frame : a.joint < b.joint;
  });
  return flips;
}

}  // namespace hair

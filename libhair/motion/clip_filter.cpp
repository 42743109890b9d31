#include <libhair/motion/clip_filter.h>

#include <algorithm>

#include <libhair/motion/rotations.h>

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

  /// How far frame f lies off the straight way from frame a to frame b.
  float off(std::ptrdiff_t a, std::ptrdiff_t f, std::ptrdiff_t b) {
    return degreesBetween((*this)[f], between(a, f, b));
  }
  glm::quat between(std::ptrdiff_t a, std::ptrdiff_t f, std::ptrdiff_t b) {
    return glm::normalize(
        glm::slerp((*this)[a], (*this)[b], static_cast<float>(f - a) / static_cast<float>(b - a)));
  }

 private:
  Clip& clip_;
  std::size_t joint_;
};

/// How crooked the path is around frames [f, f + n) without them: the worst that a frame lies off
/// its neighbours. Smooth motion, however fast, is straight over three frames.
float crookedness(Track& track, std::ptrdiff_t f, std::ptrdiff_t n) {
  constexpr std::ptrdiff_t kReach = 4;
  float worst = 0;
  for (std::ptrdiff_t i = f - 2; i >= std::max<std::ptrdiff_t>(1, f - kReach); --i)
    worst = std::max(worst, track.off(i - 1, i, i + 1));
  for (std::ptrdiff_t i = f + n + 1; i <= std::min(track.size() - 2, f + n + kReach - 1); ++i)
    worst = std::max(worst, track.off(i - 1, i, i + 1));
  return worst;
}

}  // namespace

std::vector<Flip> removeFlips(Clip& clip, const FlipSettings& settings) {
  std::vector<Flip> flips;
  for (std::size_t joint = 0; joint < clip.skeleton.jointCount(); ++joint) {
    Track track(clip, joint);
    // Short flips first: a long window over a short flip would also replace good frames.
    for (std::ptrdiff_t n = 1; n <= settings.maxFrames; ++n) {
      for (std::ptrdiff_t f = 1; f + n < track.size(); ++f) {
        const std::ptrdiff_t before = f - 1, after = f + n;
        float least = track.off(before, f, after), most = least;
        for (std::ptrdiff_t i = f + 1; i < after; ++i) {
          const float off = track.off(before, i, after);
          least = std::min(least, off);
          most = std::max(most, off);
        }
        if (least < settings.minDegrees) continue;
        // It must come back: a path that jumps and stays has gone as far as it lies off.
        const float gone = degreesBetween(track[before], track[after]);
        if (least < gone) continue;
        // The same bend is smaller over fewer frames: second differences go as the square.
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

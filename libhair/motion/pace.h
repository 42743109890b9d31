#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/core/api.h>
#include <libhair/core/error.h>

namespace HAIR_API hair {

/// Turns real time into whole frames of the simulation, all of the same length. Where drawing is
/// slow there is more to catch up with in every picture, which makes the next picture slower still:
/// so only so many frames are run a picture, and the time of the others is dropped. Motion then is
/// slow, but goes on.
class Pace {
 public:
  /// `fps`: frames a second of simulated time; `most`: frames a picture at a speed of 1 or less,
  /// in proportion more at higher speeds. Throws Error: fps not in (0, 1e4], most below 1.
  explicit Pace(double fps, int most = 2) : fps_(fps), most_(most) {
    require(fps > 0 && fps <= 1e4, "pace: ", fps, " frames a second is not in (0, 10000]");
    require(most >= 1, "pace: at most ", most, " frames a picture; take at least 1");
  }

  /// Simulated seconds a real one, [0, 100]. What is owed so far stays owed. Throws Error beyond.
  void setSpeed(double speed) {
    require(speed >= 0 && speed <= 100, "pace: a speed of ", speed, " is not in [0, 100]");
    speed_ = speed;
  }
  /// Real time that passes while paused is neither owed nor dropped.
  void setPaused(bool paused) { paused_ = paused; }
  /// As set; 1 at first.
  double speed() const { return speed_; }
  /// As set; false at first.
  bool paused() const { return paused_; }

  /// Frames to run after `seconds` more of real time. A clock that went backwards, or is not a
  /// number, stands still.
  int framesDue(double seconds) {
    if (paused_) return 0;
    owed_ += std::min(seconds > 0 ? seconds : 0.0, kLongest) * speed_ * fps_;
    // A frame that is due but for rounding is due.
    const double due = std::floor(owed_ + 1e-9);
    const double run = std::min(due, std::ceil(most_ * std::max(1.0, speed_)));
    owed_ = std::max(0.0, owed_ - due);
    dropped_ += due - run;
    return static_cast<int>(run);
  }

  /// Simulated seconds that were left out so far.
  double droppedSeconds() const { return dropped_ / fps_; }

 private:
  static constexpr double kLongest = 1e6;  // seconds; after a longer stop nobody counts

  double fps_, speed_ = 1;
  int most_;
  bool paused_ = false;
  double owed_ = 0, dropped_ = 0;  // frames
};

}  // namespace hair

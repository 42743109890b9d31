#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/core/api.h>
#include <libhair/core/error.h>

namespace HAIR_API hair {

/// Fixed time steps: converts real time into whole frames of the simulation, all of one length.
/// Where drawing is slow, each picture has more frames to catch up with, which makes the next one
/// slower still: the number of frames per picture is limited, and the time of the others is
/// dropped. Motion is then slow, but does not stall.
class FixedTimestep {
 public:
  /// `fps`: frames per simulated second; `most`: frames per picture at a speed of 1 or less, in
  /// proportion more at higher speeds. Throws Error for fps not in (0, 1e4] and most below 1.
  explicit FixedTimestep(double fps, int most = 2) : fps_(fps), most_(most) {
    require(fps > 0 && fps <= 1e4, "pace: ", fps, " frames a second is not in (0, 10000]");
    require(most >= 1, "pace: at most ", most, " frames a picture; take at least 1");
  }

  /// Simulated seconds per real second, [0, 100]. Keeps the time already owed. Throws Error beyond.
  void setSpeed(double speed) {
    require(speed >= 0 && speed <= 100, "pace: a speed of ", speed, " is not in [0, 100]");
    speed_ = speed;
  }
  /// Real time that passes while paused is neither owed nor dropped.
  void setPaused(bool paused) { paused_ = paused; }
  /// The speed; initially 1.
  double speed() const { return speed_; }
  /// Initially false.
  bool paused() const { return paused_; }

  /// Frames to run after `seconds` more of real time. Negative times and NaN count as 0.
  int framesDue(double seconds) {
    if (paused_) return 0;
    owed_ += std::min(seconds > 0 ? seconds : 0.0, kLongest) * speed_ * fps_;
    // Allow for rounding, which must not delay a frame.
    const double due = std::floor(owed_ + 1e-9);
    const double run = std::min(due, std::ceil(most_ * std::max(1.0, speed_)));
    owed_ = std::max(0.0, owed_ - due);
    dropped_ += due - run;
    return static_cast<int>(run);
  }

  /// Simulated seconds dropped so far.
  double droppedSeconds() const { return dropped_ / fps_; }

 private:
  static constexpr double kLongest = 1e6;  // seconds; longer pauses are cut

  double fps_, speed_ = 1;
  int most_;
  bool paused_ = false;
  double owed_ = 0, dropped_ = 0;  // frames
};

}  // namespace hair

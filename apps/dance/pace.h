#pragma once

#include <algorithm>
#include <cmath>

namespace hair {

/// Turns real time into whole frames of the simulation. Where drawing is slow there is more to
/// catch up with in every picture, which makes the next picture slower still: so only so many
/// frames are run a picture, and the time of the others is dropped. Motion then is slow, but goes
/// on.
class Pace {
 public:
  /// `fps`: frames a second of simulated time; `most`: frames a picture.
  explicit Pace(double fps, int most = 2) : fps_(fps), most_(most) {}

  /// Frames to run after `seconds` more of real time. `speed`: simulated seconds a real one.
  int framesDue(double seconds, double speed = 1) {
    owed_ += std::max(0.0, seconds) * speed * fps_;
    // A frame that is due but for rounding is due.
    const double due = std::floor(owed_ + 1e-9);
    const int run = static_cast<int>(std::min<double>(due, most_));
    owed_ = std::max(0.0, owed_ - due);
    dropped_ += due - run;
    return run;
  }

  /// Simulated seconds that were left out so far.
  double droppedSeconds() const { return dropped_ / fps_; }

 private:
  double fps_;
  int most_;
  double owed_ = 0, dropped_ = 0;  // frames
};

}  // namespace hair

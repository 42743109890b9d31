#pragma once

#include <cmath>

#include "bad_inputs.h"
#include "setup.h"

namespace hair::extremes {

/// So many frames the hair is disturbed.
inline constexpr int kDisturbed = 10;

/// What a Setup makes of hair and body over time. Strands hang: the groom is the only state in
/// which they can rest.
class Scene {
 public:
  explicit Scene(const Setup& setup);

  /// What is handed over in frame 1 .. kDisturbed, and before them (0).
  Inputs at(int frame) const;
  /// The same when all is over: ordinary frames under ordinary gravity, the head and what is around
  /// it where they were last.
  Inputs calm() const;

  float strandLength() const { return length_; }
  /// How far from the head's joint its hair may be, metres.
  float reach() const { return length_ + setup_.spread; }
  /// Seconds after which a strand that was thrown anywhere is back to a hundredth of its length, or
  /// 0 where that is not promised: beside colliders and much other hair, which leave a choice of
  /// sides, undamped, and so far from the origin that floats are coarser than a thousandth of a
  /// link.
  double promisedRecovery() const;

 private:
  RigidTransform headAt(int frame) const;
  std::vector<Capsule> bodyAt(int frame) const;

  Setup setup_;
  Groom groom_;
  float length_ = 0, shortest_ = INFINITY;
};

}  // namespace hair::extremes

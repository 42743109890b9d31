#pragma once

#include <apps/dance/controls.h>
#include <apps/dance/dance.h>

namespace hair {

/// What the command line says, as the panel shows it.
Controls controlsOf(const DanceOptions& options);

/// A subject on stage that obeys the panel.
class Show {
 public:
  /// The hair of `growth`, everything else of the command line. Throws Error as Subject does.
  Show(const DanceOptions& options, const Controls::Growth& growth);
  Show(const Show&) = delete;
  Show& operator=(const Show&) = delete;

  /// Passes on what has changed since the last call; shadows again where that needs it, so that a
  /// paused picture changes too.
  void apply(const Controls& controls);
  /// Sees what `before` saw, in the same light.
  void takeOver(const draw::Scene& before);
  void report(Readout& readout) const;

  Subject subject;
  Performance performance;
  Staging staging;
  ProfileLog drawn;  ///< of the frames whose drawing was timed

 private:
  Controls applied_;
  float mapExtent_;  // metres; the same for any number of cells
};

}  // namespace hair

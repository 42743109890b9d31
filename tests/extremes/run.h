#pragma once

#include <string>
#include <vector>

#include "setup.h"

namespace hair::extremes {

/// What became of one combination.
struct Outcome {
  std::string refused;                  ///< by what Error; empty: accepted
  std::vector<std::string> violations;  ///< of what is promised
  float stretch = 0;                    ///< most, of a link's length
  double energy = 0;                    ///< most of what work can have made, as a ratio of speeds
  double growth = 0;     ///< most between calm frames, of lifting a strand by its length
  double recovery = -1;  ///< seconds; < 0: not asked for
};

Outcome run(const Setup& setup);

}  // namespace hair::extremes

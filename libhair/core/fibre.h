#pragma once

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// What a drawn strand stands for. A picture draws thousands of strands for a hundred thousand
/// hairs; each then blocks the light of all the hairs it stands for.
struct Fibre {
  float width = 80e-6f;         ///< of one hair, metres; human hair: 50e-6 to 100e-6
  float opacity = 0.6f;         ///< of one hair to the light, (0, 1]
  float hairsPerStrand = 30.f;  ///< hairs that one drawn strand stands for, >= 1
};

}  // namespace hair

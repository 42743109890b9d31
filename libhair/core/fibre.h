#pragma once

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// The hairs that a drawn strand represents. A picture draws thousands of strands for a hundred
/// thousand hairs; each then blocks as much light as all the hairs that it represents.
struct Fibre {
  float width = 80e-6f;         ///< of one hair, metres; human hair: 50e-6 to 100e-6
  float opacity = 0.6f;         ///< of one hair to the light, (0, 1]
  float hairsPerStrand = 30.f;  ///< hairs that one drawn strand represents, >= 1
};

}  // namespace hair

#pragma once

#include <libhair/core/api.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// The hairs that a drawn strand represents. A picture draws thousands of strands for a hundred
/// thousand hairs; each then blocks as much light as all the hairs that it represents.
struct Fibre {
  float width = 80e-6f;         ///< of one hair, metres; human hair: 50e-6 to 100e-6
  float opacity = 0.6f;         ///< of one hair to the light, (0, 1]
  float hairsPerStrand = 30.f;  ///< hairs that one drawn strand represents, >= 1
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const Fibre*) {
  using S = Fibre;
  return std::tuple(Field("width", &S::width, "(0, 1) m"), Field("opacity", &S::opacity, "(0, 1]"),
                    Field("hairsPerStrand", &S::hairsPerStrand, "[1, 1e9)"));
}

}  // namespace hair

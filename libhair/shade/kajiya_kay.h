#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// The Kajiya-Kay reflectance model (Kajiya and Kay 1989; Bertails et al. 2005, section 3.3).
/// Colours are linear, not sRGB. Radiance of a point, summed over the lights l:
///
///   Phi = Phi_ambient + sum_l T_l · V_l · E_l · (Phi_diffuse,l + Phi_specular,l)
///
/// with E_l the light's colour; for a point light, times (distance of light and pivot / distance of
/// light and point)², the latter clamped to at least 1 cm. Ambient light is white and independent
/// of the lights. A strand of one point has no tangent and gets only the ambient term. literal.cpp
/// has the full formula.
struct KajiyaKaySettings {
  glm::vec3 rootColour{0.115f, 0.055f, 0.026f};  ///< at the root
  glm::vec3 tipColour{0.19f, 0.098f, 0.047f};    ///< at the tip; linear along the strand
  float variation = 0.25f;  ///< strands vary in lightness by up to this fraction, [0, 1]
  float ambient = 0.25f;    ///< factor of the colour, in white light from all directions
  float diffuse = 1.0f;     ///< factor of the colour, times the sine of the angle to the light
  float specular = 0.16f;   ///< factor of white, at the peak of the first highlight
  float exponent = 48.0f;   ///< of the first highlight; larger is narrower
  /// Second highlight, in the hair's colour, shifted towards the tip, for light transmitted through
  /// the fibre (after Marschner et al. 2003). 0: none, as in Kajiya and Kay.
  float secondSpecular = 0.6f;
  float secondExponent = 14.0f;  ///< of the second highlight; larger is narrower
  float firstShift = -0.06f;     ///< shift of the first highlight towards the tip, radians
  float secondShift = 0.12f;     ///< shift of the second highlight towards the tip, radians

  /// The paper's model alone: one unshifted highlight, no variation.
  static KajiyaKaySettings plain();

  /// Factor of a strand's colours, deterministic: [1 - variation, 1 + variation].
  float lightnessOf(std::uint32_t strand) const;
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const KajiyaKaySettings*) {
  using S = KajiyaKaySettings;
  return std::tuple(
      Field("rootColour", &S::rootColour, "[0, 1e6] each"),
      Field("tipColour", &S::tipColour, "[0, 1e6] each"),
      Field("variation", &S::variation, "[0, 1]"), Field("ambient", &S::ambient, "[0, 1e6]"),
      Field("diffuse", &S::diffuse, "[0, 1e6]"), Field("specular", &S::specular, "[0, 1e6]"),
      Field("exponent", &S::exponent, "[0, 1e6]"),
      Field("secondSpecular", &S::secondSpecular, "[0, 1e6]"),
      Field("secondExponent", &S::secondExponent, "[0, 1e6]"),
      Field("firstShift", &S::firstShift, "[-10, 10] radians"),
      Field("secondShift", &S::secondShift, "[-10, 10] radians"));
}

/// Throws Error that names the field and its range.
void validate(const KajiyaKaySettings& settings);

}  // namespace hair

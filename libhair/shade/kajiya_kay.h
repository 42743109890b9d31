#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/random.h>
#include <libhair/core/strands.h>
#include <libhair/shade/illumination.h>
#include <libhair/shade/shaded_points.h>

namespace HAIR_API hair {

/// How hair looks (Kajiya and Kay 1989; Bertails et al. 2005, section 3.3). Colours are linear, not
/// sRGB. Light that leaves a point, summed over the lights l:
///
///   Phi = Phi_ambient + sum_l T_l · V_l · E_l · (Phi_diffuse,l + Phi_specular,l)
///
/// with E_l the light's colour, of a light at a point times (its distance from the pivot / its
/// distance from the point)², where hair nearer than a centimetre gets what a centimetre would.
/// Ambient light belongs to no light and is white. A strand of one point has no direction and is
/// seen in its ambient colour. literal.h has the formula in full.
struct KajiyaKaySettings {
  glm::vec3 rootColour{0.115f, 0.055f, 0.026f};  ///< at the root
  glm::vec3 tipColour{0.19f, 0.098f, 0.047f};    ///< in between linear along the strand
  float variation = 0.25f;  ///< strands are up to this part lighter or darker, [0, 1]
  float ambient = 0.25f;    ///< of the colour, lit from everywhere by white light
  float diffuse = 1.0f;     ///< of the colour, times the sine of the angle to the light
  float specular = 0.16f;   ///< of white, at the peak of the first highlight
  float exponent = 48.0f;   ///< of the first highlight; larger is narrower
  /// A second highlight, in the hair's own colour, moved towards the tip, as light that went
  /// through the fibre leaves it (after Marschner et al. 2003). 0: none, as Kajiya and Kay.
  float secondSpecular = 0.6f;
  float secondExponent = 14.0f;  ///< of the second highlight; larger is narrower
  float firstShift = -0.06f;     ///< radians that the first highlight moves towards the tip
  float secondShift = 0.12f;     ///< radians that the second one does

  /// The model of the paper and nothing else: one highlight, unmoved, all strands alike.
  static KajiyaKaySettings plain();

  /// Factor of the colours of a strand, the same every time: [1 - variation, 1 + variation].
  float lightnessOf(std::uint32_t strand) const {
    constexpr std::uint32_t kUse = 0x5aade;  // of a random number
    return 1.0f + variation * (2.0f * uniform(strand, kUse) - 1.0f);
  }
};

/// Throws Error that names the field and its range.
void validate(const KajiyaKaySettings& settings);

/// Strands begin to end, on the calling thread; `shade` (appearance.h) checks and calls it.
void shadeStrands(StrandView strands, std::size_t begin, std::size_t end,
                  const Illumination& illumination, const KajiyaKaySettings& settings,
                  ShadedPoints out);

}  // namespace hair

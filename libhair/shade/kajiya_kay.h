#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>

namespace HAIR_API hair {

/// How hair looks (Kajiya and Kay 1989). Colours are linear, not sRGB.
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
};

/// Throws Error that names the field and its range.
void validate(const KajiyaKaySettings& settings);

/// What lights the hair, and where it is seen from. Refers to the caller's arrays.
struct Illumination {
  std::span<const Light> lights;  ///< empty: ambient light only
  glm::vec3 pivot{0};             ///< where the colours of lights at points are given (Light)
  glm::vec3 eye{0, 0, 1};         ///< where the picture is taken from, metres
  /// [lights · pointCount] T of the first light's points, then of the second's; or empty: no
  /// shadows, T = 1.
  std::span<const float> transmittance;
  /// [lights · pointCount] V, what opaque things (head, body) leave of each light; or empty: all.
  std::span<const float> visibility;
};

/// Colours of all points (Bertails et al. 2005, section 3.3), summed over the lights l:
///
///   Phi = Phi_ambient + sum_l T_l · V_l · E_l · (Phi_diffuse,l + Phi_specular,l)
///
/// with E_l the light's colour, of a light at a point times (its distance from the pivot / its
/// distance from the point)², where hair nearer than a centimetre gets what a centimetre would.
/// Ambient light belongs to no light and is white. Everything before the sRGB encoding is linear in
/// the lights: colours of one alone and another alone add up, less the ambient one.
/// `out`: [pointCount] sRGB, bytes in memory R, G, B, A with A = 255.
/// A strand of one point has no direction and is drawn in its ambient colour.
/// Same bits on every instruction set, for any number of threads, and for strands alone. Throws
/// Error where arrays do not fit, and as lightSpaceOf does.
void shadeKajiyaKay(StrandView strands, const Illumination& illumination,
                    const KajiyaKaySettings& settings, std::span<std::uint32_t> out);

/// Strands begin to end alone, on the calling thread; all arrays as above, [pointCount].
void shadeKajiyaKay(StrandView strands, std::size_t begin, std::size_t end,
                    const Illumination& illumination, const KajiyaKaySettings& settings,
                    std::span<std::uint32_t> out);

}  // namespace hair

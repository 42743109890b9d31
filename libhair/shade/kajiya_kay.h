#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair {

/// How hair looks (Kajiya and Kay 1989). Colours are linear, not sRGB.
struct KajiyaKaySettings {
  glm::vec3 rootColour{0.115f, 0.055f, 0.026f};
  glm::vec3 tipColour{0.19f, 0.098f, 0.047f};  ///< in between linear along the strand
  float variation = 0.25f;  ///< strands are up to this part lighter or darker, [0, 1]
  float ambient = 0.25f;    ///< of the colour, lit from everywhere
  float diffuse = 1.0f;     ///< of the colour, times the sine of the angle to the light
  float specular = 0.16f;   ///< of white, at the peak of the first highlight
  float exponent = 48.0f;   ///< of the first highlight; larger is narrower
  /// A second highlight, in the hair's own colour, moved towards the tip, as light that went
  /// through the fibre leaves it (after Marschner et al. 2003). 0: none, as Kajiya and Kay.
  float secondSpecular = 0.6f;
  float secondExponent = 14.0f;
  float firstShift = -0.06f;  ///< radians that the first highlight moves towards the tip
  float secondShift = 0.12f;  ///< radians that the second one does

  /// The model of the paper and nothing else: one highlight, unmoved, all strands alike.
  static KajiyaKaySettings plain();
};

struct ShadeLight {
  glm::vec3 direction{0, -1, 0};  ///< the way light travels, unit
  glm::vec3 colour{1};            ///< linear
  glm::vec3 eye{0, 0, 1};         ///< where the picture is taken from, metres
};

/// Colours of all points (Bertails et al. 2005, section 3.3):
///
///   Phi = Phi_ambient + T · (Phi_diffuse + Phi_specular)
///
/// `transmittance`: [pointCount] T, or empty: no shadows, T = 1. `visibility`: [pointCount], what
/// opaque things (head, body) leave of the light, or empty: all of it; T is multiplied by it.
/// `out`: [pointCount] sRGB, bytes in memory R, G, B, A with A = 255.
/// A strand of one point has no direction and is drawn in its ambient colour.
void shadeKajiyaKay(StrandView strands, std::span<const float> transmittance,
                    std::span<const float> visibility, const ShadeLight& light,
                    const KajiyaKaySettings& settings, std::span<std::uint32_t> out);

}  // namespace hair

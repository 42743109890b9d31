#pragma once

#include <array>
#include <span>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/guides/settings.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// Links of a strand that differ by more are uneven: what one of them may pull is then no measure
/// of what the next one may.
inline constexpr float kEven = 4;

/// Seconds. Hair that would take shorter ones is refused: it would stand still, as floats would not
/// tell what moves it in that time, and a frame would last for ever.
inline constexpr float kShortestSubstep = 1.0f / 20000;

/// What one guide needs to stay where it was groomed; per linear density, so lengths stand for
/// masses. Symbols as in GuideStrands.
struct RestShape {
  std::array<float, kMaxGuidePoints> linkLength{};     ///< metres
  std::array<float, kMaxGuidePoints> stiffness{};      ///< kappa_i, m³/s²
  std::array<float, kMaxGuidePoints> mass{};           ///< of each point, metres
  std::array<float, kMaxGuidePoints> tension{};        ///< of each link at rest, m²/s²
  std::array<glm::vec3, kMaxGuidePoints> curvature{};  ///< c_i, (normal, binormal, tangent)
  float longestSubstep = 0;  ///< seconds, in which floats still solve its bending
  /// Seconds, in which what its own weight pulls is a tenth of what explicit steps bear; infinite
  /// where links are even.
  float longestUnderTension = 0;
  /// Of each link m l³ / g, s² m, with m the lighter of its ends and g the torque that it carries
  /// at rest: what GuideStrands::longestSubstep goes by.
  std::array<float, kMaxGuidePoints> borne{};
};

/// Rest lengths, masses, joint stiffness and rest curvatures of a guide with these points (head
/// space, root first) under gravity. A groom that its stiffness could not hold up (a long soft
/// strand standing on end buckles) is made as stiff as it takes, with a margin.
/// Throws Error for a link without length, and for joints so stiff and short that they would take
/// substeps below 1/20000 s; `guide` names it.
RestShape makeRestShape(std::span<const glm::vec3> points, glm::vec3 rootNormal,
                        const GuideSettings& settings, std::size_t guide);

}  // namespace hair

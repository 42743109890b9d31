#pragma once

#include <array>
#include <span>

#include <glm/glm.hpp>

#include <libhair/guides/settings.h>
#include <libhair/model/groom.h>

namespace hair {

/// Largest ratio of the link lengths of an even strand. In an uneven one the tension that one link
/// can bear says nothing of that of the next.
inline constexpr float kEven = 4;

/// Seconds. Hair that needs shorter substeps is refused: its movement in one would be lost to
/// rounding, and a frame would take too long.
inline constexpr float kShortestSubstep = 1.0f / 20000;

/// The properties of one guide that keep it at rest as groomed; per linear density, so that lengths
/// stand for masses. Symbols as in GuideStrands.
struct RestShape {
  std::array<float, kMaxGuidePoints> linkLength{};     ///< metres
  std::array<float, kMaxGuidePoints> stiffness{};      ///< kappa_i, m³/s²
  std::array<float, kMaxGuidePoints> mass{};           ///< of each point, metres
  std::array<float, kMaxGuidePoints> tension{};        ///< of each link at rest, m²/s²
  std::array<glm::vec3, kMaxGuidePoints> curvature{};  ///< c_i, (normal, binormal, tangent)
  float longestSubstep = 0;  ///< seconds; floats still solve its bending system
  /// Seconds; the tension of its own weight is a tenth of the limit of explicit steps; infinite
  /// where links are even.
  float longestUnderTension = 0;
  /// m l³ / g of each link, s² m, with m the mass of its lighter end and g the torque that it
  /// carries at rest: limits GuideStrands::longestSubstep.
  std::array<float, kMaxGuidePoints> torqueLimit{};
};

/// Rest lengths, masses, joint stiffness and rest curvatures of a guide with these points (head
/// space, root first) under gravity. A groom that its stiffness could not hold up (a long soft
/// strand standing on end buckles) is stiffened until it stands, with a margin.
/// Throws Error, naming `guide`, for a link not in 1e-6 to 1e5 m, and for joints so stiff and short
/// that they would need substeps below 1/20000 s.
RestShape makeRestShape(std::span<const glm::vec3> points, glm::vec3 rootNormal,
                        const GuideSettings& settings, std::size_t guide);

}  // namespace hair

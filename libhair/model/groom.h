#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>

namespace HAIR_API hair {

/// Largest number of points of a guide. The solver's scratch for it is on the stack, and fits into
/// the first-level cache.
inline constexpr std::uint32_t kMaxGuidePoints = 64;

/// A hairstyle at rest: guide strands, which are simulated, and how drawn strands follow them
/// (Bertails et al. 2005, section 4.1; SIGGRAPH 2010 course, "Creating hair from guide strands").
///
/// Space: *head space*. Metres, +Y up, +Z where the face looks, origin at the joint on which the
/// head turns (the top of the neck).
///
/// A drawn strand s with n points is, at its point k,
///
///   sum_j weights[s][j] * G_j(k)  +  F(k) * offsets[first[s] + k]
///
/// where G_j is the Catmull-Rom curve through the points of guide parents[s][j], sampled evenly in
/// its parameter from root (k = 0) to tip (k = n - 1), and F(k) = (normal, binormal, tangent) is
/// the frame carried by parallel transport along the first of the three, the *main* guide.
struct Groom {
  std::uint32_t pointsPerGuide = 16;   ///< root and tip included, >= 2
  std::vector<glm::vec3> guidePoints;  ///< [guideCount · pointsPerGuide], root first
  /// [guideCount], or empty: number of points, from the root on, that are fixed to the head; 1 (or
  /// 0): the root alone.
  std::vector<std::uint32_t> tied;

  std::vector<std::uint32_t> first = {0};  ///< [strandCount + 1], as in StrandView
  std::vector<glm::uvec3> parents;         ///< [strandCount], guide indices; [0] is the main guide
  std::vector<glm::vec3> weights;          ///< [strandCount], sum 1
  std::vector<glm::vec3>
      offsets;  ///< [pointCount], metres in the main guide's frame, or empty: none

  Fibre fibre;  ///< of each drawn strand

  /// Number of guides.
  std::size_t guideCount() const {
    return pointsPerGuide > 0 ? guidePoints.size() / pointsPerGuide : 0;
  }
  /// Number of drawn strands.
  std::size_t strandCount() const { return parents.size(); }
  /// Number of points of all drawn strands.
  std::size_t pointCount() const { return first.back(); }
  /// Points of guide g, root first.
  std::span<const glm::vec3> guide(std::size_t g) const {
    return std::span(guidePoints).subspan(g * pointsPerGuide, pointsPerGuide);
  }
};

/// Throws Error that names the guide or strand: arrays that disagree, guides or points out of
/// range, strands of fewer than 2 points, parents that are no guides, weights that do not sum to 1,
/// numbers that are not finite, links shorter than 1e-6 or longer than 1e5 m.
void validate(const Groom& groom);
/// The part of it that a stage of guides needs.
void validateGuides(const Groom& groom);
/// The part of it that a stage of drawn strands needs.
void validateStrands(const Groom& groom);

/// Arc length of the longest guide, metres; 0 without guides.
float longestGuide(const Groom& groom);

}  // namespace hair

#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// Read-only view of strands, root first. Strand s owns points[first[s] .. first[s + 1]).
/// Every pass of the library takes this, so that callers can pass their own arrays.
struct StrandView {
  std::span<const glm::vec3> points;     ///< [pointCount], metres
  std::span<const std::uint32_t> first;  ///< [strandCount + 1], first[0] = 0, never decreasing

  /// How many strands there are.
  std::size_t strandCount() const { return first.empty() ? 0 : first.size() - 1; }
  /// Points of all strands.
  std::size_t pointCount() const { return points.size(); }
  /// Points of strand s, root first.
  std::span<const glm::vec3> strand(std::size_t s) const {
    return points.subspan(first[s], first[s + 1] - first[s]);
  }
};

/// Strands that own their arrays: flat, so that a strand is a range and not an object.
struct StrandSet {
  std::vector<glm::vec3> points;           ///< [pointCount], metres, root to tip
  std::vector<std::uint32_t> first = {0};  ///< [strandCount + 1]

  /// How many strands there are.
  std::size_t strandCount() const { return first.size() - 1; }
  /// Points of all strands.
  std::size_t pointCount() const { return points.size(); }
  /// Segments of all strands: one less than points each, none for an empty strand.
  std::size_t segmentCount() const;
  /// Points of strand s, root first.
  std::span<const glm::vec3> strand(std::size_t s) const { return view().strand(s); }
  /// The same, to change them.
  std::span<glm::vec3> strand(std::size_t s) {
    return std::span(points).subspan(first[s], first[s + 1] - first[s]);
  }
  /// Adds a strand at the end, root first. Throws Error for more than 2^32 - 1 points in all.
  void append(std::span<const glm::vec3> strandPoints);
  /// A view; valid until a strand is appended.
  StrandView view() const { return {points, first}; }
  /// Passes take a StrandView: a set is one.
  operator StrandView() const { return view(); }
};

/// Input validation: throws Error unless offsets are monotone and end at the point count, every
/// strand has at least `minPoints` points, and every coordinate is finite and below 1e8 m. `name`
/// names the source of the strands in the message (a file, an argument).
void validate(StrandView strands, std::string_view name, std::size_t minPoints = 1);

/// Length along the polyline, metres.
float arcLength(std::span<const glm::vec3> points);

/// A box along the axes; {} is empty, with lower > upper.
struct Bounds {
  glm::vec3 lower{INFINITY},  ///< least x, y and z, metres
      upper{-INFINITY};       ///< greatest x, y and z, metres

  /// Grows until it holds p.
  void extend(glm::vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  /// Its middle.
  glm::vec3 centre() const { return 0.5f * (lower + upper); }
  /// Its edges' lengths, metres.
  glm::vec3 size() const { return upper - lower; }
};

/// The least box that holds all points; empty for none.
Bounds bounds(std::span<const glm::vec3> points);

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

/// The hair that a picture shows, as the stages after its drawing need it: all of a groom, or the
/// part that a level of detail leaves. Refers to the arrays of its owner.
struct DrawnHair {
  StrandView strands;                ///< points in world space, metres; a hidden strand has none
  Fibre fibre;                       ///< what one of these strands stands for
  std::span<const float> weights{};  ///< [strandCount], share of its width a strand has; empty: 1
  /// Fibres that do not shadow the points of their own strand: 1, and more where a level of detail
  /// draws strands wider. A wider strand would shadow itself more than the full groom's does.
  float ownFibres = 1;
};

}  // namespace hair

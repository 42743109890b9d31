#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace hair {

/// A polygon of 3 or more corners seen along its Newell normal (the sum of the cross products of
/// successive corners, which is the area that it shows from its widest side). A polygon whose
/// corners are not in one plane is projected onto the plane through their mean.
struct FlatPolygon {
  explicit FlatPolygon(std::span<const glm::vec3> polygon);

  glm::dvec2 project(glm::dvec3 p) const;
  bool contains(glm::dvec2 p) const;

  glm::dvec3 origin;  ///< mean of the corners, metres
  /// The plane's axes; `u` along the first edge that has a length there, so that they move with the
  /// polygon. Zero for a polygon without area.
  glm::dvec3 u{0}, v{0}, normal{0};
  double area = 0;                  ///< square metres, of the projection
  std::vector<glm::dvec2> corners;  ///< [sides], counter-clockwise
};

/// Mean value coordinates (Floater 2003) of p in a polygon of the plane: with r_i from p to corner
/// i, and a_i the signed angle at p between corners i and i+1,
///
///   w_i = (tan(a_{i-1}/2) + tan(a_i/2)) / |r_i|,  divided by their sum.
///
/// They sum to 1 and sum_i w_i corner_i = p, everywhere; they are positive inside a convex polygon
/// (and where p sees all of the polygon). At a corner they are that corner's, on an edge linear
/// between its ends, without a jump. A polygon without area has equal weights.
void meanValueCoordinates(std::span<const glm::dvec2> polygon, glm::dvec2 p,
                          std::span<float> weights);

/// Of p, projected, in a polygon of space, projected: for a planar polygon sum_i w_i corner_i is
/// p's projection on its plane; else the point of a smooth surface through the polygon's edges that
/// lies above or below p's projection.
void meanValueCoordinates(std::span<const glm::vec3> polygon, glm::vec3 p,
                          std::span<float> weights);

}  // namespace hair

#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace hair {

/// A polygon of 3 or more corners projected along its Newell normal (the sum of the cross products
/// of successive corners; the direction in which its projected area is largest). A polygon whose
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
/// (and where all of the polygon is visible from p). They are 1 at their own corner, linear along
/// edges, and continuous. A polygon without area has equal weights.
void meanValueCoordinates(std::span<const glm::dvec2> polygon, glm::dvec2 p,
                          std::span<float> weights);

/// Mean value coordinates of the projection of p in the projection of a polygon in space: for a
/// planar polygon sum_i w_i corner_i is p's projection on its plane; else the point of a smooth
/// surface through the polygon's edges that lies above or below p's projection.
void meanValueCoordinates(std::span<const glm::vec3> polygon, glm::vec3 p,
                          std::span<float> weights);

}  // namespace hair

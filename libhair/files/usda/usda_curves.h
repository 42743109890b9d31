#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hair {

/// A kind of UsdGeomBasisCurves.
struct UsdaCurveKind {
  enum class Basis : std::uint8_t { Linear, Bezier, BSpline, CatmullRom } basis = Basis::Linear;
  enum class Wrap : std::uint8_t { Nonperiodic, Periodic, Pinned } wrap = Wrap::Nonperiodic;
  bool operator==(const UsdaCurveKind&) const = default;
};

/// A point on a curve, as a sum of the curve's vertices.
struct UsdaCurvePoint {
  std::array<std::uint32_t, 4> vertex;  ///< of the curve, from 0
  std::array<float, 4> weight;          ///< sum 1
  std::uint32_t varying, nextVarying;   ///< values of `varying` interpolation around it
  float t;                              ///< from the one to the next
};

/// The polyline of a curve of so many vertices: linear curves as they are, cubic ones (bases as in
/// openusd.org/release/api/class_usd_geom_basis_curves.html) at even parameters, at least eight
/// segments a curve, four a Bézier segment, two of the others. A closed curve is opened at its
/// first point; one of too few vertices for its kind is straight between them. Empty where a Bézier
/// curve cannot have so many.
std::vector<UsdaCurvePoint> pointsOfCurve(UsdaCurveKind kind, std::uint32_t vertices);

/// How many values of `varying` interpolation a curve has.
std::uint32_t varyingOfCurve(UsdaCurveKind kind, std::uint32_t vertices);

}  // namespace hair

#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <libhair/files/usda/usda_layer.h>

namespace hair {

/// Where a prim stands at a time: column vectors, from the prim's space into the stage's
/// (UsdGeomXformable: openusd.org/release/api/class_usd_geom_xformable.html). Operations in the
/// order of xformOpOrder, the last one first; `!invert!` and `!resetXformStack!`; values between
/// time samples are linear, rotations by `orient` along the shortest arc. Throws Error (file, line,
/// cause).
glm::dmat4 stageFromPrim(UsdaScanner& in, const UsdaLayer& layer, std::size_t prim, double time);

/// Adds the times of all samples that stageFromPrim depends on.
void addTransformTimes(const UsdaLayer& layer, std::size_t prim, std::vector<double>& times);

/// The samples of an attribute around a time, and how far it is from the first to the second; both
/// are the same before the first sample, after the last and at one.
struct UsdaBetween {
  UsdaScanner::Place before, after;
  double t = 0;
};
UsdaBetween samplesAround(const UsdaLayer::Attribute& attribute, double time);

}  // namespace hair

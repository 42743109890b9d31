#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/opacity_map.h>
#include <libhair/shadow/methods/shadow_map.h>

namespace hair::literal {

// Transmittance at `points` (metres, world) by a shadow method as its paper has it: every segment
// clipped against every pixel that a point reads, sums in double, on one thread; no walk from pixel
// to pixel, no tables, no fixed point. Slow; the references for tests of the methods, with which
// they share the image (makeLightImage) alone. The factor for strands' own shadows is not in them.
// Return [points.size()]. Arguments are not checked.

/// Opacity shadow maps (Kim and Neumann 2001). The optical depth in front of a plane, at `slices`
/// equal steps from the nearest hair to the farthest, linear in between.
std::vector<double> transmittance(StrandView strands, const Fibre& fibre, const LightSpace& light,
                                  const OpacityMapSettings& settings,
                                  std::span<const glm::vec3> points);

/// Deep opacity maps (Yuksel and Keyser 2008). The same with planes from each pixel's own nearest
/// hair on, at distances that grow. For 32 depthBits.
std::vector<double> transmittance(StrandView strands, const Fibre& fibre, const LightSpace& light,
                                  const DeepOpacityMapSettings& settings,
                                  std::span<const glm::vec3> points);

/// Shadow map (Williams 1978) with percentage-closer filtering (Reeves, Salesin and Cook 1987): the
/// share of the pixels whose centres are within filterRadius of the point, or of the point's own if
/// there are none, whose nearest hair is not in front of the point.
std::vector<double> transmittance(StrandView strands, const LightSpace& light,
                                  const ShadowMapSettings& settings,
                                  std::span<const glm::vec3> points);

}  // namespace hair::literal

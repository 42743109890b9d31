#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <libhair/shadow/methods/fragment_lists.h>
#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// A depth interval over which optical depth grows linearly; a step if from = to.
struct DepthBin {
  float from,          ///< depth along the light, in pixels
      to;              ///< >= from, in pixels
  float opticalDepth;  ///< of the whole piece
};

/// The clusters of one ray, from fragments to bins (sections 3.2 and 3.3). The weight of a fragment
/// is its optical depth, the paper's beta. In short, `iterations` times:
///
///   mu_j    = sum beta d / sum beta                   over the fragments nearest to mu_j, eq. 3
///
/// then, once,
///
///   sigma_j = sqrt(sum beta (mu_j - d)² / sum beta)   over the fragments nearest to the new mu_j
///   bin_j   = [mu_j - sqrt(3) sigma_j, mu_j + sqrt(3) sigma_j]
///
/// and where bin j reaches into bin j + 1 both end halfway, R_j = L_{j+1} = (R_j + L_{j+1}) / 2. A
/// bin holds the fragments in it; one between two bins goes to the nearer mu.
///
/// `fragments`: front to back. `bins`: [>= settings.clusters]; returns how many were made: at most
/// `clusters`, fewer where clusters stayed empty. They are disjoint, front to back, lie between the
/// first and the last fragment and together have the optical depth of all fragments. A bin narrower
/// than `leastWidth` is widened to it, away from the light, if there is room: a lone fragment would
/// be a step, and rounding would decide on which side of it its own fibre is.
std::size_t clusterFragments(std::span<const PixelFragment> fragments,
                             const DensityClusteringSettings& settings, float leastWidth,
                             std::span<DepthBin> bins);

/// Optical depth in front of `depth`; a step at `depth` itself is not in front of it. Bins are
/// front to back. Never decreases with depth, to the last bit.
float opticalDepthAt(std::span<const DepthBin> bins, float depth);

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDensityClustering(const DensityClusteringSettings& settings);

}  // namespace hair

#pragma once

#include <memory>
#include <span>
#include <vector>

#include <libhair/shadow/methods/fragment_lists.h>
#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// A vertex of a visibility function: linear between two, a step between two at the same depth, 1
/// in front of the first, constant behind the last.
struct VisibilityVertex {
  float depth;          ///< along the light, in pixels
  float transmittance;  ///< [0, 1]
};

/// Appends the vertices of a function within `tolerance` (to rounding) of the product of
/// exp(-optical depth) of the fragments in front: it begins at 1, stays in [0, 1] and never
/// increases. `fragments`: front to back; none: no vertex. At most two vertices a fragment.
///
/// A piece begins at the end of the previous one. The range of slopes within the tolerance of all
/// fragments so far shrinks with each fragment; when it is empty, the piece ends at the last
/// feasible fragment, with the middle of the feasible slopes (Lokovic and Veach 2000, on
/// compression). Where a fragment's step exceeds the tolerance, the piece ends at it and the next
/// begins below the step.
void compressVisibility(std::span<const PixelFragment> fragments, float tolerance,
                        std::vector<VisibilityVertex>& vertices);

/// The function at a depth; a step at `depth` itself is not in front of it.
float transmittanceAt(std::span<const VisibilityVertex> vertices, float depth);

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDeepShadowMap(const DeepShadowMapSettings& settings);

}  // namespace hair

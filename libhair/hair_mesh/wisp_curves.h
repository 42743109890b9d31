#pragma once

#include <libhair/core/api.h>
#include <libhair/hair_mesh/styling.h>
#include <libhair/model/styles.h>

namespace HAIR_API hair {

/// Strands of a mesh as the curves of wisps (Yuksel et al. 2009, section 3.4 and figure 9).
struct WispCurveSettings {
  /// The curves, and their styling. `points` are the guides'.
  StrandGroup curves{.strands = 200, .points = 16};
  /// How strands fill them: its strands, points, seed, hairs, and what fills a wisp, from `clumpBy`
  /// on. The rest is about the built-in head and says nothing here; a wisp has one curve, so that
  /// `spread` says how far its strands come together and `clump` says nothing.
  StyleSettings fill{.spread = 0.15f};
};

/// A groom whose guides are the wisp curves, with links of equal length, and whose drawn strands
/// have roots of their own on the scalp: each follows the curve whose root is nearest, of its own
/// bundle if that has one, and keeps its position in the wisp (as Choe and Ko 2005: a master
/// strand, and what distinguishes others from it). Throws Error as growHair and for fewer than 3
/// points of a curve, fewer than 2 of a strand, or no curves or strands.
Groom wispGroom(const HairMesh& mesh, const WispCurveSettings& settings = {},
                const ScalpDensity& density = {});

}  // namespace hair

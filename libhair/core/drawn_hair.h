#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/fibre.h>
#include <libhair/core/strands.h>

namespace HAIR_API hair {

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

#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/density/density_grid.h>

namespace HAIR_API hair {

/// The quantity that a grid accumulates, as an amount per metre of a segment.
struct SegmentMeasure {
  /// The length that the amount is proportional to.
  enum class Of : std::uint8_t {
    Length,   ///< the segment's length
    AcrossX,  ///< its projection across the grid's X axis; in a curved grid times the
              ///< magnification (CellFrame), because nearer to the focus it subtends more
  };
  Of of = Of::Length;   ///< see Of
  double perMetre = 1;  ///< amount per metre, any unit, >= 0
  /// Deposit::Points: amount per point, >= 0. 0: that of the strands' mean length per point, for
  /// uniformly distributed directions.
  float perPoint = 0;
};

/// Metres of hair, for strands that represent `hairsPerStrand` hairs: the measure of
/// self-collision.
inline SegmentMeasure metresOfHair(float hairsPerStrand = 1) {
  return {SegmentMeasure::Of::Length, static_cast<double>(hairsPerStrand)};
}

/// Adds strands to a cleared grid (Bertails et al. 2005, section 3.1), on all threads; the counts
/// are integers, so the result has the same bits for any number of threads.
///
/// Splats every strandStride-th strand, weighted by strandStride (1 to 2^30 - 1). `weights`:
/// [strandCount], [0, 1], scales the amount of each strand; empty: 1. Deposit::Points counts whole
/// points and ignores them.
///
/// Reports overflow: grid.saturatedCells counts saturated cells, and grid.aliased() tells whether
/// the hair is larger than the grid. May be called again to add more; Deposit::Points then uses the
/// amount per point of the first call. Throws Error for a grid that was never cleared, and
/// arguments out of range.
void deposit(StrandView strands, const SegmentMeasure& measure, DensityGrid& grid,
             std::uint32_t strandStride = 1, std::span<const float> weights = {});

/// Mean length of strand per point, metres, of at most 256 of every strandStride-th strand. 0 for
/// no points.
float metresPerPoint(StrandView strands, std::uint32_t strandStride = 1);

}  // namespace hair

#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/density/density_grid.h>

namespace HAIR_API hair {

/// What is summed up in the cells of a grid: an amount for each metre of a segment.
struct SegmentMeasure {
  /// Of what a segment adds an amount a metre.
  enum class Of : std::uint8_t {
    Length,   ///< of its length
    AcrossX,  ///< of its part across the grid's X axis; in a curved grid times the magnification
              ///< (CellFrame), as things look larger from the focus
  };
  Of of = Of::Length;   ///< what the amount is of
  double perMetre = 1;  ///< amount, of whatever unit, >= 0; of strands that are read
  /// Deposit::Points: the amount that a point adds, >= 0. 0: as much as segments do that are as
  /// long as the strands' are on average, in all directions alike.
  float perPoint = 0;
};

/// Metres of hair, for strands that stand for so many hairs each: the measure of self-collision.
inline SegmentMeasure metresOfHair(float hairsPerStrand = 1) {
  return {SegmentMeasure::Of::Length, static_cast<double>(hairsPerStrand)};
}

/// Adds strands to a cleared grid (Bertails et al. 2005, section 3.1), on all threads; the counts
/// are integers, so the result has the same bits for any number of threads.
///
/// Only every strandStride-th strand is read, and counts for that many (1 to 2^30 - 1). `weights`:
/// [strandCount], [0, 1], what share of its amount each strand adds, or empty: all of it;
/// Deposit::Points, which counts whole points, takes no notice of them.
///
/// Adds nothing silently wrong: grid.saturatedCells counts the cells whose sum did not fit, and
/// grid.aliased() says whether the hair is larger than the grid. May be called again to add more;
/// with Deposit::Points all of it counts as the points of the first call did. Throws Error for a
/// grid that was never cleared, and arguments out of range.
void deposit(StrandView strands, const SegmentMeasure& measure, DensityGrid& grid,
             std::uint32_t strandStride = 1, std::span<const float> weights = {});

/// Metres of strand that a point stands for, of every strandStride-th strand: the mean over at most
/// 256 of them. 0 for no points.
float metresPerPoint(StrandView strands, std::uint32_t strandStride = 1);

}  // namespace hair

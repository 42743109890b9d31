#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <libhair/core/strands.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/segment_walk.h>

namespace hair {

// Kernels for sixteen points or segments at a time, on the CPU's vectors. Counts are bit-identical
// to the scalar code, on every CPU.

/// Counts below this are added in vectors.
inline constexpr std::uint32_t kManyCounts = 0x40000000u;

/// Strands begin · stride, (begin + 1) · stride, ..., (end - 1) · stride.
struct StrandRange {
  std::size_t begin, end;
  std::uint32_t stride;
  std::span<const float> weights{};  ///< of all strands, or empty: all 1
};

/// Adds `stride`, below kManyCounts, to the cell of each point.
void writePoints(StrandView strands, StrandRange range, CellWriter& writer);

/// Deposit::Columns. A segment longer than `longest` cells goes into its first cell undivided.
void writeColumns(StrandView strands, StrandRange range, const SegmentScale& scale, float longest,
                  CellWriter& writer);

/// Adds counts below kManyCounts to unwrapped cells. size: a multiple of kLanes.
void writeCounts(const int* x, const int* y, const int* z, const std::uint32_t* counts,
                 std::size_t size, CellWriter& writer);

/// Total length of every step-th strand, metres.
double sumOfLengths(StrandView strands, std::size_t step);

}  // namespace hair
